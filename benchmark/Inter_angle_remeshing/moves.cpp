// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices that may not move as they want to, as tables in Markdown: without relaxation, with a half of them constrained, and with functors
// that say which moves are allowed, which PMP takes from CGAL 6 on. Means over ten models at so many times their mean edge length.

#include "Result_row.h"
#include "meshes.h"

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/centroid.h>
#include <CGAL/version.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

namespace {

constexpr double FACTORS[] = {.5, 1, 2};

// `parameters_for(mesh)` are those of both functions.
template <class Parameters_for>
void print_rows(const char* name, bool is_peer_of_use, const Parameters_for& parameters_for)
{
  for (const double factor : FACTORS) {
    Result_row ours{name}, theirs{"PMP"};
    for (const char* model : {"elephant", "bear", "homer", "knot1", "blobby", "dino", "lion-head", "fandisk", "joint", "anchor_dense"}) {
      const Mesh mesh = read_mesh(CGAL::data_file_path(std::string("meshes/") + model + ".off"));
      const double mean = mean_edge_length(mesh), length = factor * mean;
      const auto np = parameters_for(mesh);
      ours.add(mesh, mesh, length, [&](Mesh& m) { IAR::isotropic_remeshing(faces(m), length, m, np); });
      if (is_peer_of_use)
        theirs.add(mesh, mesh, length, [&](Mesh& m) { PMP::isotropic_remeshing(faces(m), length, m, np); });
    }
    ours.print(factor, is_peer_of_use ? theirs : ours);
    if (is_peer_of_use) theirs.print(factor, theirs);
  }
}

// Vertices stay inside of the input, or outside, or on it.
class Keeps_its_side
{
public:
  explicit Keeps_its_side(const Mesh& mesh) : side_(new CGAL::Side_of_triangle_mesh<Mesh, Kernel>(mesh)) {}
  bool operator()(Mesh::Vertex_index, const Kernel::Point_3& from, const Kernel::Point_3& to) const
  {
    return (*side_)(from) == (*side_)(to);
  }

private:
  std::shared_ptr<CGAL::Side_of_triangle_mesh<Mesh, Kernel>> side_;
};

double middle_x(const Mesh& mesh)
{
  return CGAL::centroid(mesh.points().begin(), mesh.points().end(), CGAL::Dimension_tag<0>()).x();
}

}

int main()
{
  using Vertex = Mesh::Vertex_index;
  using Point = Kernel::Point_3;
  const auto ten = []() { return parameters::number_of_iterations(10); };
  Result_row::print_head("factor");
  print_rows("no relaxation", true, [&](const Mesh&) { return ten().number_of_relaxation_steps(0); });
  std::printf("\n");
  Result_row::print_head("factor");
  print_rows("a half constrained", true, [&](const Mesh& mesh) {
    const std::size_t n = mesh.number_of_vertices();
    const auto is_constrained = [&mesh, n, x = middle_x(mesh)](Vertex v) { return std::size_t(v) < n && mesh.point(v).x() < x; };
    return ten().vertex_is_constrained_map(boost::make_function_property_map<Vertex>(is_constrained)); });
  std::printf("\n");
  Result_row::print_head("factor");
  const bool does_peer_ask = CGAL_VERSION_MAJOR >= 6;
  print_rows("no move", does_peer_ask, [&](const Mesh&) {
    return ten().allow_move_functor([](Vertex, const Point&, const Point&) { return false; }); });
  print_rows("moves of a half", does_peer_ask, [&](const Mesh& mesh) {
    return ten().allow_move_functor([x = middle_x(mesh)](Vertex, const Point&, const Point& to) { return to.x() < x; }); });
  print_rows("moves on one side", does_peer_ask, [&](const Mesh& mesh) { return ten().allow_move_functor(Keeps_its_side(mesh)); });
}
