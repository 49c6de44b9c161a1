// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_SURFACE_DISTANCE_H
#define CGAL_INTER_ANGLE_REMESHING_SURFACE_DISTANCE_H

#include <CGAL/Inter_angle_remeshing/internal/compatibility.h>
#include <CGAL/Inter_angle_remeshing/triangle_quality.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
 * \ingroup PkgInterAngleRemeshingRef
 *
 * @brief tells how far two surfaces are apart, in both directions. Lengths are in the unit of the coordinates.
 *
 * The maxima are taken over finitely many points of a surface, so they are lower bounds of the Hausdorff distances.
 */
struct Surface_distance
{
  /// the largest distance from a point of the first surface to the second one
  double hausdorff_1_to_2 = 0;

  /// the largest distance from a point of the second surface to the first one
  double hausdorff_2_to_1 = 0;

  /// the mean distance from the points of the first surface to the second one, every area counting the same
  double mean_1_to_2 = 0;

  /// the mean distance from the points of the second surface to the first one, every area counting the same
  double mean_2_to_1 = 0;

  /// the length of the diagonal of the bounding box of the faces of the first mesh
  double diagonal = 0;

  /// returns the larger of the two Hausdorff distances.
  double hausdorff() const { return (std::max)(hausdorff_1_to_2, hausdorff_2_to_1); }

  /// returns the larger of the two mean distances.
  double mean() const { return (std::max)(mean_1_to_2, mean_2_to_1); }

  /// returns `hausdorff()` as a fraction of `diagonal`; 0 where that is 0.
  double relative_hausdorff() const { return relative(hausdorff()); }

  /// returns `mean()` as a fraction of `diagonal`; 0 where that is 0.
  double relative_mean() const { return relative(mean()); }

private:
  double relative(const double length) const { return diagonal == 0 ? 0. : length / diagonal; }
};

namespace internal {
namespace measures {

// The surfaces are copied to plain doubles, near the origin and of about unit size. Thus any kernel will do, distances
// of tiny and of huge meshes are equally accurate, and threads share nothing of the user's.
using Distance_kernel = CGAL::Simple_cartesian<double>;

// A kernel whose projection on a triangle is accurate whatever the triangle's shape. CGAL's own goes through the
// equation of the plane: with plain doubles, and a needle of unit length and a width of 1e-12, distances came out too
// large by up to 1e-5; for thinner ones by as much as the needle is long.
struct Distance_traits : Distance_kernel
{
  using Point = Distance_kernel::Point_3;
  using Vector = Distance_kernel::Vector_3;
  using Triangle = Distance_kernel::Triangle_3;

  class Construct_projected_point_3
  {
    struct Nearest
    {
      const Point& query;
      Point point;
      double squared_distance;

      void offer(const Point& candidate)
      {
        const double d = CGAL::squared_distance(query, candidate);
        if(d < squared_distance)
        {
          squared_distance = d;
          point = candidate;
        }
      }

      void offer_segment(const Point& source, const Vector& direction)
      {
        const double length = direction.squared_length();
        if(length > 0)
          offer(source + std::clamp((query - source) * direction / length, 0., 1.) * direction);
      }
    };

  public:
    Point operator()(const Triangle& t, const Point& query) const
    {
      const Point& a = t[0];
      const Vector ab = t[1] - a, ac = t[2] - a, aq = query - a;
      Nearest nearest{query, a, aq.squared_length()};
      nearest.offer_segment(a, ab);
      nearest.offer_segment(a, ac);
      nearest.offer_segment(t[1], t[2] - t[1]);

      const Vector normal = CGAL::cross_product(ab, ac);
      const double area = normal.squared_length();
      const double weight_b = CGAL::cross_product(aq, ac) * normal;
      const double weight_c = CGAL::cross_product(ab, aq) * normal;
      if(area > 0 && weight_b >= 0 && weight_c >= 0 && weight_b + weight_c <= area)
        nearest.offer(a + (weight_b / area) * ab + (weight_c / area) * ac);
      return nearest.point;
    }
  };

  Construct_projected_point_3 construct_projected_point_3_object() const { return {}; }
};

struct Flat_surface
{
  std::vector<Triangle_coordinates> triangles; // one for every face, in their order
  std::vector<Coordinates> vertices;           // those of the faces, each one once
};

template <class Vertex, class TriangleMesh>
bool has_face(const Vertex v, const TriangleMesh& tm)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  if(halfedge(v, tm) == Graph_traits::null_halfedge())
    return false;
  for(const auto h : CGAL::halfedges_around_target(v, tm))
    if(!CGAL::is_border(h, tm))
      return true;
  return false;
}

template <class TriangleMesh, class NamedParameters>
Flat_surface flat_surface(const TriangleMesh& tm, const NamedParameters& np, const std::string& name)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  Flat_surface surface;
  for(const auto f : faces(tm))
    surface.triangles.push_back(checked_triangle(f, surface.triangles.size(), name, tm, vpm));
  if(surface.triangles.empty())
    refuse("!faces(tm).empty()", name + " has no face, so there is no distance to it", __FILE__, __LINE__);

  for(const auto v : vertices(tm))
    if(has_face(v, tm))
      surface.vertices.push_back(double_coordinates(get(vpm, v)));
  return surface;
}

struct Bounding_box
{
  Coordinates lower, upper;

  explicit Bounding_box(const std::vector<Coordinates>& points) : lower(points.front()), upper(points.front())
  {
    for(const Coordinates& p : points)
      for(std::size_t i = 0; i < 3; ++i)
      {
        lower[i] = (std::min)(lower[i], p[i]);
        upper[i] = (std::max)(upper[i], p[i]);
      }
  }

  double largest_coordinate() const
  {
    double largest = 0;
    for(std::size_t i = 0; i < 3; ++i)
      largest = (std::max)({largest, std::abs(lower[i]), std::abs(upper[i])});
    return largest;
  }
};

// Moves both surfaces to the origin and scales them by a power of two: neither adds an error beyond the one that a
// coordinate has anyway, and no product of coordinates overflows or vanishes.
class Normalization
{
  int exponent = 0; // of two, above every coordinate
  Coordinates center = {}; // after the scaling

public:
  Normalization(const Bounding_box& first, const Bounding_box& second)
  {
    std::frexp((std::max)(first.largest_coordinate(), second.largest_coordinate()), &exponent);
    for(std::size_t i = 0; i < 3; ++i)
      center[i] = .5 * (scaled((std::min)(first.lower[i], second.lower[i])) +
                        scaled((std::max)(first.upper[i], second.upper[i])));
  }

  Distance_kernel::Point_3 apply(const Coordinates& p) const
  {
    return {scaled(p[0]) - center[0], scaled(p[1]) - center[1], scaled(p[2]) - center[2]};
  }

  double restore_length(const double length) const { return std::ldexp(length, exponent); }

private:
  double scaled(const double coordinate) const { return std::ldexp(coordinate, -exponent); }
};

using Distance_point = Distance_kernel::Point_3;
using Distance_triangle = Distance_kernel::Triangle_3;

struct Normalized_surface
{
  std::vector<Distance_triangle> triangles;
  std::vector<Distance_point> vertices;

  Normalized_surface(const Flat_surface& surface, const Normalization& normalization)
  {
    triangles.reserve(surface.triangles.size());
    for(const Triangle_coordinates& t : surface.triangles)
      triangles.emplace_back(normalization.apply(t[0]), normalization.apply(t[1]), normalization.apply(t[2]));
    vertices.reserve(surface.vertices.size());
    for(const Coordinates& p : surface.vertices)
      vertices.push_back(normalization.apply(p));
  }
};

// Random numbers that are the same everywhere: the standard fixes the generator, but none of its distributions.
class Unit_interval_generator
{
  std::mt19937_64 generator;

public:
  explicit Unit_interval_generator(const std::uint64_t seed) : generator(seed) {}

  // uniform in [0, 1): the upper 53 bits, as many as a double has
  double operator()() { return static_cast<double>(generator() >> 11) * 0x1p-53; }
};

inline double doubled_area(const Distance_triangle& t)
{
  return std::sqrt(CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length());
}

// A point of `t` from two numbers in [0, 1): a parallelogram is filled evenly, and folded along its diagonal.
inline Distance_point point_in_triangle(const Distance_triangle& t, double along_first, double along_second)
{
  if(along_first + along_second > 1)
  {
    along_first = 1 - along_first;
    along_second = 1 - along_second;
  }
  return t[0] + along_first * (t[1] - t[0]) + along_second * (t[2] - t[0]);
}

// The surface is laid out as one strip of its triangles and cut in `number` pieces of equal area; each piece gets one
// random point. Every area has the expected number of samples as with independent ones, at a smaller variance.
inline std::vector<Distance_point> sample_surface(const Normalized_surface& surface, const std::size_t number,
                                                  const std::uint64_t seed, const std::string& name)
{
  double total_area = 0;
  for(const Distance_triangle& t : surface.triangles)
    total_area += doubled_area(t);
  if(total_area == 0)
    refuse("area(tm) > 0", name + " has no area, so there is no mean distance from it", __FILE__, __LINE__);

  Unit_interval_generator random(seed);
  std::vector<Distance_point> samples;
  samples.reserve(number);
  auto triangle = surface.triangles.begin();
  double end_of_triangle = doubled_area(*triangle); // on the strip
  for(std::size_t i = 0; i < number; ++i)
  {
    const double position = (static_cast<double>(i) + random()) / static_cast<double>(number) * total_area;
    while(end_of_triangle <= position && std::next(triangle) != surface.triangles.end())
      end_of_triangle += doubled_area(*++triangle);
    const double along_first = random(); // one by one: the order in which arguments are evaluated is not fixed
    const double along_second = random();
    samples.push_back(point_in_triangle(*triangle, along_first, along_second));
  }
  return samples;
}

template <class ConcurrencyTag, class Function>
void for_each_block(const std::size_t number_of_blocks, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>)
  {
    tbb::parallel_for(std::size_t(0), number_of_blocks, function);
    return;
  }
#endif
  for(std::size_t block = 0; block < number_of_blocks; ++block)
    function(block);
}

struct Distance_summary
{
  double maximum = 0;
  double sum = 0;
};

using Distance_primitive = AABB_triangle_primitive<Distance_traits, std::vector<Distance_triangle>::const_iterator>;
using Distance_tree = CGAL::AABB_tree<AABB_traits<Distance_traits, Distance_primitive>>;

// The blocks, and the order in which they are added up, depend on the number of points only: so does every bit.
template <class ConcurrencyTag>
Distance_summary summarize_distances(const std::vector<Distance_point>& points, const Distance_tree& tree)
{
  constexpr std::size_t block_size = 512; // about 0.5 ms: long against starting a task, short against the whole
  const std::size_t number_of_blocks = (points.size() + block_size - 1) / block_size;
  std::vector<Distance_summary> blocks(number_of_blocks);
  for_each_block<ConcurrencyTag>(number_of_blocks, [&](const std::size_t block)
  {
    Distance_summary summary;
    const std::size_t end = (std::min)(points.size(), (block + 1) * block_size);
    for(std::size_t i = block * block_size; i < end; ++i)
    {
      const double distance = std::sqrt(CGAL::squared_distance(points[i], tree.closest_point(points[i])));
      summary.maximum = (std::max)(summary.maximum, distance);
      summary.sum += distance;
    }
    blocks[block] = summary;
  });

  Distance_summary total;
  for(const Distance_summary& block : blocks)
  {
    total.maximum = (std::max)(total.maximum, block.maximum);
    total.sum += block.sum;
  }
  return total;
}

struct One_sided_distance
{
  double hausdorff;
  double mean;
};

template <class ConcurrencyTag>
One_sided_distance one_sided_distance(const std::vector<Distance_point>& samples,
                                      const std::vector<Distance_point>& vertices,
                                      const std::vector<Distance_triangle>& target)
{
  Distance_tree tree(target.begin(), target.end());
  tree.build();                       // here rather than at the first query, for which several threads would wait
  tree.accelerate_distance_queries(); // pays from some hundred queries on

  const Distance_summary from_samples = summarize_distances<ConcurrencyTag>(samples, tree);
  const Distance_summary from_vertices = summarize_distances<ConcurrencyTag>(vertices, tree);
  return {(std::max)(from_samples.maximum, from_vertices.maximum),
          from_samples.sum / static_cast<double>(samples.size())};
}

struct Sampling_options
{
  std::size_t number = 100000; // the mean is then known to about 1 / sqrt(100000), that is, 0.3% of itself
  std::uint64_t seed = 0;
};

// What `np` says, or else `defaults`.
template <class NamedParameters>
Sampling_options sampling_options(const NamedParameters& np, const Sampling_options& defaults)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto number = choose_parameter(get_parameter(np, internal_np::number_of_points_on_faces), defaults.number);
  const auto seed = choose_parameter(get_parameter(np, internal_np::random_seed), defaults.seed);
  if(!(number > 0))
    refuse("number_of_points_on_faces > 0", "number_of_points_on_faces must be positive", __FILE__, __LINE__);
  return {static_cast<std::size_t>(number), static_cast<std::uint64_t>(seed)};
}

} // namespace measures
} // namespace internal

/*!
 * \ingroup PkgInterAngleRemeshingRef
 *
 * @brief measures how far two surfaces are apart: the Hausdorff distance and the mean distance, in both directions.
 *
 * From each surface random points are taken, of which every part gets a number in proportion to its area; the mean is
 * the one of their distances to the other surface. The maximum is also taken over the vertices of the faces, where a
 * surface often is farthest from the other one. The distances of these points are exact but for rounding.
 *
 * The result is the same, to the last bit, in every run, for every `ConcurrencyTag` and number of threads; with the
 * same sampling parameters for both meshes, interchanging the meshes interchanges the two directions (and `diagonal` is
 * that of the other mesh). The random numbers are the same on every platform.
 *
 * @tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or
 *         `CGAL::Parallel_if_available_tag`; `CGAL::Parallel_tag` requires \ref thirdpartyTBB
 * @tparam TriangleMesh1 a model of `FaceListGraph` and `VertexListGraph`
 * @tparam TriangleMesh2 a model of `FaceListGraph` and `VertexListGraph`
 * @tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
 * @tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tm1 the first triangulated surface mesh; its bounding box is the one of `Surface_distance::diagonal`
 * @param tm2 the second triangulated surface mesh
 * @param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `tm1`, among the ones listed below
 * @param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `tm2`, among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of the mesh}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` of any kernel
 *                    as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_points_on_faces}
 *     \cgalParamDescription{the number of random points on the mesh}
 *     \cgalParamType{an integer number, positive}
 *     \cgalParamDefault{`100000` in `np1`; the number for `tm1` in `np2`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{random_seed}
 *     \cgalParamDescription{the seed of the random points on the mesh}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`0` in `np1`; the seed for `tm1` in `np2`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @throw CGAL::Precondition_exception if a mesh has no face or no area, if a face is not a triangle or has a coordinate
 *        that is not finite as a `double`, or if a number of points is not positive; the message names the mesh, and
 *        the face by its place in `faces(tm)`, counted from 0. Release builds check this, too.
 *
 * Faces without an area are surface, too; vertices without a face are not. Neither a large distance from the origin nor
 * the scale matters.
 *
 * Complexity: the search trees take \f$ O(n \log n) \f$ for *n* faces in both meshes, and the \f$ O(n + s) \f$ queries
 * for *s* points about \f$ O(\log n) \f$ each where the surfaces are close to one another.
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh1, class TriangleMesh2,
          class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters>
Surface_distance surface_distance(const TriangleMesh1& tm1, const TriangleMesh2& tm2,
                                  const NamedParameters1& np1 = parameters::default_values(),
                                  const NamedParameters2& np2 = parameters::default_values())
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>,
                "surface_distance(): CGAL::Parallel_tag was asked for, but the program is not linked with TBB. "
                "Link with CGAL::TBB_support, or use CGAL::Parallel_if_available_tag.");
#endif
  using namespace internal::measures;
  const Sampling_options options_1 = sampling_options(np1, Sampling_options());
  const Sampling_options options_2 = sampling_options(np2, options_1);

  const Flat_surface flat_1 = flat_surface(tm1, np1, "the first mesh");
  const Flat_surface flat_2 = flat_surface(tm2, np2, "the second mesh");
  const Bounding_box box_1(flat_1.vertices), box_2(flat_2.vertices);
  const Normalization normalization(box_1, box_2);
  const Normalized_surface surface_1(flat_1, normalization), surface_2(flat_2, normalization);
  const auto samples_1 = sample_surface(surface_1, options_1.number, options_1.seed, "the first mesh");
  const auto samples_2 = sample_surface(surface_2, options_2.number, options_2.seed, "the second mesh");

  const One_sided_distance forth =
    one_sided_distance<ConcurrencyTag>(samples_1, surface_1.vertices, surface_2.triangles);
  const One_sided_distance back =
    one_sided_distance<ConcurrencyTag>(samples_2, surface_2.vertices, surface_1.triangles);
  const double diagonal =
    std::sqrt(CGAL::squared_distance(normalization.apply(box_1.lower), normalization.apply(box_1.upper)));

  Surface_distance result;
  result.hausdorff_1_to_2 = normalization.restore_length(forth.hausdorff);
  result.hausdorff_2_to_1 = normalization.restore_length(back.hausdorff);
  result.mean_1_to_2 = normalization.restore_length(forth.mean);
  result.mean_2_to_1 = normalization.restore_length(back.mean);
  result.diagonal = normalization.restore_length(diagonal);
  return result;
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_SURFACE_DISTANCE_H
