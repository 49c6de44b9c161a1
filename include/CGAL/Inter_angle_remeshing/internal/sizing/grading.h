// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_GRADING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_GRADING_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/necks.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/sizing.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The target length at each vertex: that of the sizing field; and where curves have short edges, because details are small or
// strips narrow, it falls to theirs, as it does around necks. It rises by so much and no more with the distance.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The target lengths of vertices, as parts of the target length of the run.
class Grading
{
public:
  using Index = Remeshing_mesh::Index;

  bool is_uniform() const { return part_.empty(); }
  bool has_field() const { return !field_.empty(); }
  double part(Index v) const { return at(part_, v); }
  // The target of an edge between u and v.
  double part(Index u, Index v) const { return 0.5 * (part(u) + part(v)); }
  // The same before curves are looked at.
  double field_part(Index v) const { return at(field_, v); }
  double field_part(Index u, Index v) const { return 0.5 * (field_part(u) + field_part(v)); }

  double largest_field_part() const { return has_field() ? double(*std::max_element(field_.begin(), field_.end())) : 1.; }

  // A new vertex on an edge between u and v.
  void inherit(Index vertex, Index u, Index v)
  {
    if (!is_uniform()) set(part_, vertex, part(u, v));
    if (has_field()) set(field_, vertex, field_part(u, v));
  }

  // The number of equilateral faces that have the area of the mesh, each with edges of the least length at the corners of the face
  // where it lies.
  double number_of_faces(const Remeshing_mesh& mesh, double target_length) const
  {
    double result = 0;
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      if (!mesh.is_face(f)) continue;
      const auto& v = mesh.face_record(f).vertex;
      const double l = target_length * (std::min)({part(v[0]), part(v[1]), part(v[2])});
      result += 2 / std::sqrt(3.) * length(mesh.cross_product(f)) / (l * l);
    }
    return result;
  }

  // Takes the parts of all vertices from the field, or 1 where it is uniform; see `sink_at_curves()` and `sink_at_necks()`.
  template <class ConcurrencyTag>
  void read(const Remeshing_mesh& mesh, const Sizing& sizing, const Input_locator* locator, double target_length)
  {
    part_.assign(mesh.number_of_vertex_slots(), 1);
    if (sizing.is_uniform()) return;
    for_each_block<ConcurrencyTag>(part_.size(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (Index v = Index(begin); v < Index(end); ++v)
        if (mesh.is_vertex(v)) part_[v] = float(sizing.part_at(mesh, v, locator));
    });
    std::vector<Index> all;
    for (Index v = 0; v < Index(part_.size()); ++v)
      if (mesh.is_vertex(v)) all.push_back(v);
    lower_around(mesh, target_length, STEEPEST_FIELD, all, [](Index) { return true; });
    check_number_of_faces(mesh, target_length);
    field_ = part_;
  }

  // Lowers the parts at short edges of curves, and around them: they rise by `rate` over a unit of length. Protected
  // edges say nothing about details, nor do those at vertices for which `is_settled(v)` does not hold.
  template <class Predicate>
  void sink_at_curves(const Remeshing_mesh& mesh, double target_length, double rate, const Predicate& is_settled)
  {
    std::vector<Index> sunk;
    for (Index v = 0; v < Index(part_.size()); ++v) {
      if (!mesh.is_vertex(v) || !mesh.is_on_curve(v)) continue;
      double sum = 0;
      int edges = 0;
      bool has_fixed_ends = false;
      for_each_curve_halfedge(mesh, v, [&](Index h) {
        has_fixed_ends = has_fixed_ends || mesh.is_between_fixed_ends(h < 0 ? ~h : h);
        sum += length(mesh.position(mesh.source(mesh.opposite(h))) - mesh.position(v));
        ++edges;
      });
      if (edges == 0 || has_fixed_ends) continue;
      const double bound = CURVE_EDGE * sum / (edges * target_length), before = part(v);
      if (bound >= (has_field() ? YIELDING : 1.) * before || !is_settled(v)) continue;
      part_[v] = float((std::max)(SMALLEST * before, bound));
      sunk.push_back(v);
    }
    lower_around(mesh, target_length, rate, sunk, [&](Index v) { return !mesh.is_on_curve(v); });
  }

  // The same around necks.
  void sink_at_necks(const Remeshing_mesh& mesh, const std::vector<Neck_vertex>& necks, double target_length, double rate)
  {
    std::vector<Index> sunk;
    for (const Neck_vertex& neck : necks) {
      const double bound = (std::max)(SMALLEST, neck.length / target_length);
      if (bound >= part(neck.vertex)) continue;
      part_[neck.vertex] = float(bound);
      sunk.push_back(neck.vertex);
    }
    lower_around(mesh, target_length, rate, sunk, [](Index) { return true; });
  }

private:
  // The target is a little longer than the mean curve edge, and at least this part of what it would be else.
  static constexpr double CURVE_EDGE = 1.05, SMALLEST = 0.3;
  // A field says how long edges are to be: it yields where the mean curve edge is shorter than this part of that.
  static constexpr double YIELDING = 0.6;
  // A field that rises faster than this leaves triangles no room to grow.
  static constexpr double STEEPEST_FIELD = 0.5;
  // A vertex whose part falls by less need not be looked at again.
  static constexpr float NOTICEABLE = 1.01f;

  static double at(const std::vector<float>& parts, Index v)
  {
    return std::size_t(v) < parts.size() ? double(parts[v]) : 1.;
  }
  static void set(std::vector<float>& parts, Index v, double part)
  {
    if (std::size_t(v) >= parts.size()) parts.resize(std::size_t(v) + 1, 1);
    parts[v] = float(part);
  }

  // A function of the position may be far smaller somewhere than where it was asked before. Faces as large as the field lets them be
  // at one of their corners, and as it may let them grow towards the middle of a large face, are the fewest there can be.
  void check_number_of_faces(const Remeshing_mesh& mesh, double target_length) const
  {
    double fewest = 0;
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      if (!mesh.is_face(f)) continue;
      const auto& v = mesh.face_record(f).vertex;
      const double area = length(mesh.cross_product(f)), growth = STEEPEST_FIELD * std::sqrt(area);
      const double l = target_length * (std::max)({part(v[0]), part(v[1]), part(v[2])}) + growth;
      fewest += 2 / std::sqrt(3.) * area / (l * l);
    }
    if (!(fewest <= MAXIMUM_NUMBER_OF_FACES)) refuse_too_small_field();
  }

  // Lowers the parts beside the vertices of the queue that rise faster than by `rate` over a unit of length, as far as
  // `may_fall(v)` holds.
  template <class Predicate>
  void lower_around(const Remeshing_mesh& mesh, double target_length, double rate, std::vector<Index>& queue,
                   const Predicate& may_fall)
  {
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Index v = queue[i];
      mesh.for_each_neighbor(v, [&](Index u) {
        if (!(part_[u] > part_[v] * NOTICEABLE && may_fall(u))) return;
        const double distance = length(mesh.position(u) - mesh.position(v)) / target_length;
        const float bound = float(double(part_[v]) + rate * distance);
        if (!(part_[u] > bound * NOTICEABLE)) return;
        part_[u] = bound;
        queue.push_back(u);
      });
    }
  }

  std::vector<float> part_;              // by vertex; empty: 1 everywhere
  std::vector<float> field_;             // before curves are looked at; empty: 1 everywhere
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_GRADING_H
