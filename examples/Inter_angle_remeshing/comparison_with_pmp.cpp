// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshes one mesh with CGAL::Polygon_mesh_processing and with this package, prints a table that compares the results,
// and writes the one of this package.

#include <CGAL/Inter_angle_remeshing/detect_features.h>
#include <CGAL/Inter_angle_remeshing/isotropic_remeshing.h>
#include <CGAL/Inter_angle_remeshing/surface_distance.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace IAR = CGAL::Inter_angle_remeshing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

const char* const usage =
  "usage: comparison_with_pmp [mesh] [-f factor | -l length] [-o result]\n"
  "  mesh       OFF, OBJ, PLY or STL file with triangles (default: the elephant that comes with CGAL)\n"
  "  -f factor  target edge length as a multiple of the mean edge length of the mesh (default: 1)\n"
  "  -l length  target edge length in the unit of the mesh\n"
  "  -o result  file for the new mesh (default: <mesh>_remeshed.off in the current folder)\n";

constexpr unsigned int number_of_iterations = 10;

struct Options
{
  std::string mesh;
  std::string result;
  double factor = 1;
  double length = 0; // 0: by the factor
};

struct Remeshed
{
  Mesh mesh;
  double milliseconds;
};

double positive_number(const std::string& text)
{
  std::size_t end = 0;
  double number = 0;
  try { number = std::stod(text, &end); } catch(const std::exception&) {}
  if(end != text.size() || !std::isfinite(number) || number <= 0)
    throw std::runtime_error("'" + text + "' is not a positive number.");
  return number;
}

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  for(auto argument = arguments.begin(); argument != arguments.end(); ++argument)
  {
    const std::string& option = *argument;
    if(option.empty() || option[0] != '-')
    {
      options.mesh = option;
      continue;
    }
    if(option != "-f" && option != "-l" && option != "-o")
      throw std::runtime_error("there is no option " + option + ".");
    if(++argument == arguments.end())
      throw std::runtime_error("a value must follow " + option + ".");
    if(option == "-f")
      options.factor = positive_number(*argument);
    else if(option == "-l")
      options.length = positive_number(*argument);
    else
      options.result = *argument;
  }
  if(options.mesh.empty())
    options.mesh = CGAL::data_file_path("meshes/elephant.off");
  if(options.result.empty())
    options.result = std::filesystem::path(options.mesh).stem().string() + "_remeshed.off";
  return options;
}

[[noreturn]] void refuse(const std::string& filename, const std::string& reason)
{
  throw std::runtime_error(filename + " " + reason);
}

// Some of CGAL's readers and writers print what they stumble over; the sentence of this program is enough.
template <class Function>
bool silently(const Function& function)
{
  std::cerr.setstate(std::ios::failbit);
  const bool result = function();
  std::cerr.clear();
  return result;
}

// Refuses polygons that are not triangles between given, finite points.
void check_triangles(const std::string& filename, const std::vector<Point>& points,
                     const std::vector<std::vector<std::size_t> >& polygons)
{
  if(polygons.empty())
    refuse(filename, "has no faces.");
  for(const Point& p : points)
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      refuse(filename, "has a coordinate that is not a finite number.");
  for(const auto& polygon : polygons)
  {
    if(polygon.size() != 3)
      refuse(filename, "has a face with " + std::to_string(polygon.size()) + " vertices; all must be triangles.");
    for(const std::size_t index : polygon)
      if(index >= points.size())
        refuse(filename, "has a face with a vertex that does not exist.");
  }
}

// Reads polygons rather than a mesh: an STL file has no connectivity, and what is wrong can be told.
Mesh read_mesh(const std::string& filename)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!silently([&]() { return CGAL::IO::read_polygon_soup(filename, points, polygons); }))
    refuse(filename, "cannot be read as an OFF, OBJ, PLY or STL file.");
  check_triangles(filename, points, polygons);

  PMP::repair_polygon_soup(points, polygons); // merges equal points and drops triangles with fewer than three of them
  if(!PMP::orient_polygon_soup(points, polygons))
    refuse(filename, "is not an orientable manifold: an edge or a vertex joins several sheets.");

  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if(!(PMP::area(mesh) > 0))
    refuse(filename, "has only faces without an area.");
  return mesh;
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Mesh::Edge_index e : edges(mesh))
    sum += PMP::edge_length(halfedge(e, mesh), mesh);
  return sum / static_cast<double>(num_edges(mesh));
}

// Remeshes fresh copies; the median of three is not disturbed by one slow run, such as the first.
template <class Remesh>
Remeshed run(const Mesh& input, const Remesh& remesh)
{
  using Clock = std::chrono::steady_clock;
  std::array<double, 3> milliseconds;
  Mesh mesh;
  for(double& time : milliseconds)
  {
    mesh = input;
    const auto start = Clock::now();
    remesh(mesh);
    time = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  mesh.collect_garbage();
  return {mesh, milliseconds[1]};
}

std::string text(const double value, const int digits)
{
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(digits) << value;
  return stream.str();
}

// The cells below the title, in the order of `row_titles`.
using Column = std::array<std::string, 11>;

const Column row_titles = {"faces", "min angle (degrees)", "max angle (degrees)", "theta_avg (degrees)", "valence 6 (%)",
                           "faces that the input forces", "min angle of the others", "max angle of the others",
                           "Hausdorff distance (% of diagonal)", "mean distance (% of diagonal)", "time (ms)"};

Column quality_column(const Mesh& mesh)
{
  Mesh marked = mesh;
  const auto is_feature = marked.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  IAR::detect_features(faces(marked), marked, is_feature);
  const IAR::Inter_angle_statistics angles =
    IAR::inter_angle_statistics(marked, CGAL::parameters::edge_is_constrained_map(is_feature));
  return {std::to_string(angles.number_of_faces), text(angles.minimum_angle, 1), text(angles.maximum_angle, 1),
          text(angles.average, 2), text(angles.percentage_of_regular_vertices(), 1),
          std::to_string(angles.number_of_forced_faces), text(angles.minimum_unforced_angle, 1),
          text(angles.maximum_unforced_angle, 1), "-", "-", "-"};
}

Column result_column(const Mesh& input, const Remeshed& result)
{
  Column column = quality_column(result.mesh);
  const IAR::Surface_distance distance = IAR::surface_distance(input, result.mesh);
  column[8] = text(100 * distance.relative_hausdorff(), 3);
  column[9] = text(100 * distance.relative_mean(), 4);
  column[10] = text(result.milliseconds, 1);
  return column;
}

void print_row(const std::string& title, const std::string& a, const std::string& b, const std::string& c)
{
  std::cout << std::left << std::setw(36) << title << std::right
            << std::setw(12) << a << std::setw(12) << b << std::setw(14) << c << '\n';
}

void print_table(const Column& input, const Column& pmp, const Column& ours)
{
  print_row("", "input", "PMP", "this package");
  const bool forces_none = input[5] == "0" && pmp[5] == "0" && ours[5] == "0";
  for(std::size_t i = 0; i < row_titles.size(); ++i)
    if(!forces_none || i < 5 || i > 7)
      print_row(row_titles[i], input[i], pmp[i], ours[i]);
}

void compare(const Options& options, const Mesh& input)
{
  const double length = options.length > 0 ? options.length : options.factor * mean_edge_length(input);
  const auto iterations = CGAL::parameters::number_of_iterations(number_of_iterations);

  // This package first: it refuses a length that would lead to more faces than a mesh can have.
  const Remeshed ours = run(input, [&](Mesh& mesh) { IAR::isotropic_remeshing(faces(mesh), length, mesh, iterations); });
  const Remeshed pmp = run(input, [&](Mesh& mesh) { PMP::isotropic_remeshing(faces(mesh), length, mesh, iterations); });

  std::cout << options.mesh << ": target edge length " << length << ", " << number_of_iterations << " iterations\n\n";
  print_table(quality_column(input), result_column(input, pmp), result_column(input, ours));

  const auto precision = CGAL::parameters::stream_precision(17);
  if(!silently([&]() { return CGAL::IO::write_polygon_mesh(options.result, ours.mesh, precision); }))
    refuse(options.result, "cannot be written.");
  std::cout << "\nThe result of this package is in " << options.result << std::endl;
}

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if(!arguments.empty() && (arguments[0] == "-h" || arguments[0] == "--help"))
  {
    std::cout << usage;
    return EXIT_SUCCESS;
  }
  try
  {
    const Options options = parse(arguments);
    compare(options, read_mesh(options.mesh));
  }
  catch(const std::exception& error)
  {
    std::cerr << "comparison_with_pmp: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
