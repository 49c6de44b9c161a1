// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A callback that shows the progress and stops the run, and a visitor that sums up what each pass did.

#include <CGAL/Inter_angle_remeshing/Default_visitor.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>

namespace IAR = CGAL::Inter_angle_remeshing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// What is of no interest is inherited, and costs nothing.
struct Counting_visitor
  : IAR::Default_visitor
{
  std::map<IAR::Pass, std::size_t> operations;
  std::size_t single_splits = 0;

  template <class AnyMesh>
  void end_pass(const IAR::Pass pass, const AnyMesh&, const std::size_t count) { operations[pass] += count; }

  template <class AnyVertex, class AnyMesh>
  void after_split(AnyVertex, const AnyMesh&) { ++single_splits; }
};

int main()
{
  const std::string filename = CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << filename << " cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  // Goes on until more than half is done, as if somebody had pressed a button.
  double progress = 0;
  bool is_monotone = true;
  const auto callback = [&](const double done)
  {
    is_monotone = is_monotone && progress <= done && done <= 1;
    progress = done;
    std::cout << "\r" << static_cast<int>(100 * done) << "%" << std::flush;
    return done < 0.5;
  };

  // By std::ref: named parameters are copied, and the counts would end up in a copy.
  Counting_visitor visitor;
  const IAR::Remeshing_report report = IAR::isotropic_remeshing(IAR::Face_count(10000), mesh,
    CGAL::parameters::callback(callback).visitor(std::ref(visitor)));

  std::cout << "\nstopped in iteration " << report.iterations << ", with " << report.output_faces << " faces: "
            << visitor.operations[IAR::Pass::split] << " splits, " << visitor.operations[IAR::Pass::collapse]
            << " collapses, " << visitor.operations[IAR::Pass::flip] << " flips, "
            << visitor.operations[IAR::Pass::glide] << " glides\n";

  // The mesh holds the result so far, complete and on the surface.
  const bool is_sound = CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh) && CGAL::is_closed(mesh);
  const bool is_counted = visitor.single_splits == report.splits &&
                          visitor.operations[IAR::Pass::split] == report.splits &&
                          visitor.operations[IAR::Pass::collapse] == report.collapses &&
                          visitor.operations[IAR::Pass::flip] == report.flips;
  const bool is_cancelled = report.ending == IAR::Remeshing_report::Ending::cancelled;
  return is_cancelled && is_monotone && is_sound && is_counted ? EXIT_SUCCESS : EXIT_FAILURE;
}
