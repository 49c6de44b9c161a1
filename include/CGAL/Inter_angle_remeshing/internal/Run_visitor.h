// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_VISITOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_VISITOR_H

#include <CGAL/Inter_angle_remeshing/Default_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh_graph.h>

#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The visitor that passes tell what they do, whatever the user handed over; this one does nothing.
class Run_visitor
{
public:
  virtual ~Run_visitor() = default;

  // Whether there is anyone to tell.
  virtual bool listens() const { return false; }

  virtual void start_iteration(unsigned, const Remeshing_mesh&) {}
  virtual void end_iteration(unsigned, const Remeshing_mesh&) {}
  virtual void start_pass(Pass, const Remeshing_mesh&) {}
  virtual void end_pass(Pass, const Remeshing_mesh&, std::size_t) {}
  virtual void before_split(Mesh_halfedge, const Remeshing_mesh&) {}
  virtual void after_split(Mesh_vertex, const Remeshing_mesh&) {}
  virtual void before_collapse(Mesh_halfedge, const Remeshing_mesh&) {}
  virtual void after_collapse(Mesh_vertex, const Remeshing_mesh&) {}
  virtual void before_flip(Mesh_halfedge, const Remeshing_mesh&) {}
  virtual void after_flip(Mesh_halfedge, const Remeshing_mesh&) {}
  virtual void before_move(Mesh_vertex, const Remeshing_mesh&) {}
  virtual void after_move(Mesh_vertex, const Remeshing_mesh&) {}
};

// Passes everything on to a visitor of the user's.
template <class Visitor>
class User_visitor final : public Run_visitor
{
public:
  explicit User_visitor(Visitor& visitor) : visitor_(visitor) {}

  Visitor& user() { return visitor_; }

  bool listens() const override { return true; }

  void start_iteration(unsigned i, const Remeshing_mesh& mesh) override { visitor_.start_iteration(i, mesh); }
  void end_iteration(unsigned i, const Remeshing_mesh& mesh) override { visitor_.end_iteration(i, mesh); }
  void start_pass(Pass pass, const Remeshing_mesh& mesh) override { visitor_.start_pass(pass, mesh); }
  void end_pass(Pass pass, const Remeshing_mesh& mesh, std::size_t count) override { visitor_.end_pass(pass, mesh, count); }
  void before_split(Mesh_halfedge h, const Remeshing_mesh& mesh) override { visitor_.before_split(h, mesh); }
  void after_split(Mesh_vertex v, const Remeshing_mesh& mesh) override { visitor_.after_split(v, mesh); }
  void before_collapse(Mesh_halfedge h, const Remeshing_mesh& mesh) override { visitor_.before_collapse(h, mesh); }
  void after_collapse(Mesh_vertex v, const Remeshing_mesh& mesh) override { visitor_.after_collapse(v, mesh); }
  void before_flip(Mesh_halfedge h, const Remeshing_mesh& mesh) override { visitor_.before_flip(h, mesh); }
  void after_flip(Mesh_halfedge h, const Remeshing_mesh& mesh) override { visitor_.after_flip(h, mesh); }
  void before_move(Mesh_vertex v, const Remeshing_mesh& mesh) override { visitor_.before_move(v, mesh); }
  void after_move(Mesh_vertex v, const Remeshing_mesh& mesh) override { visitor_.after_move(v, mesh); }

private:
  Visitor& visitor_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_VISITOR_H
