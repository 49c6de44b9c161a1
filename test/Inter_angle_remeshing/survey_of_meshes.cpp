// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every mesh of CGAL's data folder, in whatever state it is, at several target lengths and with default parameters: each run
// ends, and leaves a valid mesh of triangles with finite coordinates and the topology of the input, or refuses it in words and
// leaves it as it was. Takes minutes; not a part of the default tests.
//
//   survey_of_meshes [file or folder...]

#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>

#include <CGAL/Real_timer.h>

#include "check.h"
#include "invariants.h"
#include "meshes.h"
#include "models.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
using namespace invariants;

void survey(const std::string& file)
{
  const Mesh input = models::from_file(file);
  const std::string name = std::filesystem::path(file).filename().string();
  if(is_empty(input))
  {
    std::cout << name << ": no triangles" << std::endl;
    return;
  }
  const bool is_valid = CGAL::is_valid_polygon_mesh(input);     // not where points belong to no face
  const Topology before = topology(input);
  const double mean = mean_edge_length(input);
  for(const double factor : {.5, 1., 2., 5.})
  {
    Mesh output = input;
    CGAL::Real_timer timer;
    timer.start();
    try
    {
      const IAR::Remeshing_report report = IAR::isotropic_remeshing(factor * mean, output);
      std::cout << std::setprecision(3) << name << ", " << factor << ": " << input.number_of_faces() << " to "
                << output.number_of_faces() << " faces, angles " << report.angles_after.minimum << " to "
                << report.angles_after.maximum << ", " << timer.time() << " s" << std::endl;
      CHECK_MESSAGE(output.is_valid(false) && CGAL::is_triangle_mesh(output), name << ", " << factor);
      CHECK_MESSAGE(CGAL::is_valid_polygon_mesh(output) || !is_valid, name << ", " << factor);
      CHECK_MESSAGE(is_finite(output), name << ", " << factor);
      CHECK_MESSAGE(topology(output) == before, name << ", " << factor << ": " << topology(output) << "; before: " << before);
      CHECK_MESSAGE(report.output_faces == output.number_of_faces(), name << ", " << factor);
    }
    catch(const CGAL::Precondition_exception& refusal)
    {
      std::cout << name << ", " << factor << ": refused: " << refusal.message() << std::endl;
      CHECK_MESSAGE(!refusal.message().empty(), name << ", " << factor);
      CHECK_MESSAGE(meshes::Picture<Mesh>(output) == meshes::Picture<Mesh>(input), name << ", " << factor);
    }
  }
}

int main(int argc, char* argv[])
{
  std::vector<std::string> files;
  const auto add = [&](const std::filesystem::path& path) {
    if(!std::filesystem::is_directory(path))
      files.push_back(path.string());
    else
      for(const auto& entry : std::filesystem::directory_iterator(path))
        files.push_back(entry.path().string());
  };
  for(int i = 1; i < argc; ++i)
    add(argv[i]);
  if(argc == 1)
    add(std::filesystem::path(CGAL::data_file_path("meshes/elephant.off")).parent_path());
  std::sort(files.begin(), files.end());
  for(const std::string& file : files)
    survey(file);
  return result();
}
