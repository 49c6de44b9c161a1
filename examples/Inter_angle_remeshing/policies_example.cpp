// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The rules of inter-angle optimization as policies: their parameters, their use outside of a run, and how one policy
// decorates another.

#include <CGAL/Inter_angle_remeshing/Edge_profile.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_collapse_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_flip_policy.h>
#include <CGAL/Inter_angle_remeshing/Policies/Inter_angle_split_policy.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A policy of one's own. As the base of `Inter_angle_flip_policy` it is asked first, and for the flips of glides too,
// which the paper's rules let pass: creases stay, whatever the valences would gain.
struct Keeps_creases
{
  double largest_angle; // between the normals of the two faces, in degrees

  template <class Profile>
  bool operator()(const Profile& edge) const { return edge.dihedral_angle() <= largest_angle; }
};

// How many edges of the user's own mesh a policy would let flip: policies do not depend on a run.
template <class Policy>
std::size_t number_of_permitted_flips(const Mesh& mesh, const Policy& policy)
{
  std::size_t count = 0;
  for(const Mesh::Edge_index e : edges(mesh))
  {
    const IAR::Edge_profile<Mesh> profile(halfedge(e, mesh), mesh, mesh.points());
    if(!profile.is_border() && policy(profile))
      ++count;
  }
  return count;
}

template <class NamedParameters>
bool remeshes_well(const std::string& title, Mesh mesh, const double length, const NamedParameters& np)
{
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(faces(mesh), length, mesh, np);
  std::cout << title << ": " << report.output_faces << " faces, angles " << report.angles_after.minimum << " to "
            << report.angles_after.maximum << " degrees, theta_avg " << report.angles_after.average << "; "
            << report.splits << " splits, " << report.collapses << " collapses, " << report.flips << " flips, "
            << report.glides << " glides\n";
  return report.angles_after.average > report.angles_before.average;
}

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/dino.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  // The second rule, about creases, is turned off here and taken over by the base.
  const IAR::Inter_angle_flip_policy<> no_obtuse(90, 180);
  const IAR::Inter_angle_flip_policy<Keeps_creases> no_obtuse_no_crease(90, 180, Keeps_creases{20});
  const std::size_t permitted = number_of_permitted_flips(mesh, no_obtuse);
  const std::size_t permitted_with_base = number_of_permitted_flips(mesh, no_obtuse_no_crease);
  std::cout << "edges of the input whose flip makes no obtuse angle: " << permitted << " of " << num_edges(mesh)
            << ", and lies on no crease: " << permitted_with_base << "\n";

  const double length = IAR::target_edge_length(faces(mesh), mesh, 6000);
  const bool all_well =
    remeshes_well("default policies", mesh, length, CGAL::parameters::default_values()) &&
    remeshes_well("the paper's", mesh, length,
                  CGAL::parameters::do_split(IAR::Inter_angle_split_policy<>(90))
                                   .do_collapse(IAR::Inter_angle_collapse_policy<>(true, true)) // border, degree
                                   .do_flip(IAR::Inter_angle_flip_policy<>(90, 20))) &&
    remeshes_well("milder ones", mesh, length,
                  CGAL::parameters::do_split(IAR::Inter_angle_split_policy<>(100))
                                   .do_flip(IAR::Inter_angle_flip_policy<>(120, 45))) &&
    remeshes_well("creases kept", mesh, length, CGAL::parameters::do_flip(no_obtuse_no_crease)) &&
    remeshes_well("no rules", mesh, length,
                  CGAL::parameters::do_split(true).do_collapse(true).do_flip(true)); // plain Botsch-Kobbelt

  // A base policy can only forbid more.
  return all_well && permitted_with_base < permitted ? EXIT_SUCCESS : EXIT_FAILURE;
}
