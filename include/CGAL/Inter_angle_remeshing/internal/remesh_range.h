// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H

#include <CGAL/Inter_angle_remeshing/Face_count.h>
#include <CGAL/Inter_angle_remeshing/internal/Remesher.h>
#include <CGAL/Inter_angle_remeshing/internal/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/corners.h>
#include <CGAL/Inter_angle_remeshing/internal/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh_exchange.h>
#include <CGAL/Inter_angle_remeshing/internal/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/upsampling.h>
#include <CGAL/Inter_angle_remeshing/target_edge_length.h>

#include <CGAL/Simple_cartesian.h>
#ifdef CGAL_EIGEN3_ENABLED
#  include <CGAL/Inter_angle_remeshing/Projection/Point_set_MLS_projector.h>
#endif

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// From a range and its parameters to the result: reads the range, sets up the reference surface and the projector,
// runs the remesher, writes the result back. The user's mesh is changed in the last step alone.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

constexpr const char* REMESHING = "isotropic_remeshing()";

// Everything that isotropic_remeshing() reads from its named parameters.
template <class VertexPointMap, class EdgeIsConstrainedMap, class VertexIsConstrainedMap, class PatchMap,
          class SplitPolicy, class CollapsePolicy, class FlipPolicy, class ProjectionFunctor, class Visitor>
struct Remeshing_parameters
{
  VertexPointMap vertex_point_map;
  EdgeIsConstrainedMap edge_is_constrained_map;
  VertexIsConstrainedMap vertex_is_constrained_map;
  PatchMap face_patch_map;
  SplitPolicy split_policy;
  CollapsePolicy collapse_policy;
  FlipPolicy flip_policy;
  ProjectionFunctor projection_functor;
  Visitor& visitor;
  Recipe recipe;
  Schedule schedule;
  Constraint_settings constraint_settings;
  bool may_collapse_constraints;
  bool does_project;
};

inline void check_recipe(const Recipe& recipe)
{
  if (!(recipe.split_ratio > 1 && recipe.split_ratio <= 2))
    refuse(REMESHING, "Recipe::split_ratio is " + std::to_string(recipe.split_ratio) + "; it must lie in (1, 2]");
  if (!(recipe.collapse_ratio >= 0 && recipe.collapse_ratio < 1 &&
        1.2 * recipe.collapse_ratio <= recipe.split_ratio))
    refuse(REMESHING, "Recipe::collapse_ratio is " + std::to_string(recipe.collapse_ratio) +
                      "; it must lie in [0, 1) and be at most split_ratio / 1.2");
  if (!(recipe.relaxation > 0 && recipe.relaxation <= 1.6))
    refuse(REMESHING, "Recipe::relaxation is " + std::to_string(recipe.relaxation) + "; it must lie in (0, 1.6]");
  if (recipe.glide_depth > MAXIMUM_GLIDE_DEPTH)
    refuse(REMESHING, "Recipe::glide_depth is " + std::to_string(recipe.glide_depth) + "; at most " +
                      std::to_string(MAXIMUM_GLIDE_DEPTH) + " is possible");
  if (!(recipe.lower_angle >= 0 && recipe.lower_angle < 60 && recipe.upper_angle > 60 && recipe.upper_angle <= 180))
    refuse(REMESHING, "the band of angles [" + std::to_string(recipe.lower_angle) + ", " +
                      std::to_string(recipe.upper_angle) + "] of the recipe must lie in [0, 180] and hold 60 inside");
  if (!(recipe.grading >= 0))
    refuse(REMESHING, "Recipe::grading is negative or not a number");
  if (!(recipe.collapse_tolerance >= 0))
    refuse(REMESHING, "Recipe::collapse_tolerance is negative or not a number");
}

// A length so small that the result could not be indexed is refused, as is what is no length. Needles have edges to
// split, though hardly an area.
inline void check_length(double length, double area, double total_edge_length)
{
  if (!(length >= 0) || !std::isfinite(length))
    refuse(REMESHING, "the target edge length is " + std::to_string(length) + "; it must be finite and not negative");
  constexpr double MAXIMUM_FACES = double((std::numeric_limits<Remeshing_mesh::Index>::max)() / 4) / 1.5;
  const double faces = (std::max)(4 * area / (std::sqrt(3.) * length * length), total_edge_length / length);
  if (length > 0 && faces > MAXIMUM_FACES)
    refuse(REMESHING, "the target edge length is so small that about " + std::to_string(faces) +
                      " faces were needed; at most " + std::to_string(MAXIMUM_FACES) + " can be indexed");
}

// The target length in the units of the flat mesh.
template <class Length>
double target_length(const Length& length, const Remeshing_mesh& mesh, double total_edge_length)
{
  const double range_area = area(mesh);
  double result;
  if constexpr (std::is_same<Length, Face_count>::value) {
    if (length.value == 0) refuse(REMESHING, "the wanted number of faces is 0");
    result = length_for_face_count(range_area, length.value);
  } else {
    const double wanted = CGAL::to_double(length);
    if (std::isfinite(wanted)) result = wanted / mesh.unit(); else result = wanted;
  }
  check_length(result, range_area, total_edge_length);
  return result;
}

// Gives each vertex the face of the surface where it lies. A vertex starts from its neighbor's face; where that walk
// does not lead onto the surface, the place is searched for.
inline void find_hints(Remeshing_mesh& mesh, const Surface_projection& projection)
{
  using Index = Remeshing_mesh::Index;
  constexpr double ON_SURFACE = 1e-20;          // squared distance; the extent of the mesh is about 1
  constexpr int SCANS = 4;                      // building the search structure takes as long as some ten scans
  int searches = 0;
  std::vector<char> is_found(mesh.number_of_vertex_slots(), 0);
  std::vector<Index> queue, missed;
  const auto is_reached_from = [&](Index v, Index hint) {
    mesh.hint(v) = hint;
    return squared_distance(projection(mesh.position(v), mesh.hint(v)), mesh.position(v)) <= ON_SURFACE;
  };
  const auto search = [&](Index v) {
    Vector3 normal;
    mesh.for_each_around(v, [&](Index h) {
      normal += triangle_cross(mesh.position(v), mesh.position(mesh.target(h)), mesh.position(mesh.apex(h)));
    });
    const Vector3 q = projection.factor * mesh.position(v);
    if (++searches <= SCANS) projection.surface.locate_by_scan(q, mesh.hint(v), normal);
    else projection.surface.locate(q, mesh.hint(v), normal);
  };
  for (Index seed = 0; seed < Index(mesh.number_of_vertex_slots()); ++seed) {
    if (!mesh.is_vertex(seed) || is_found[seed]) continue;
    search(seed);
    is_found[seed] = 1;
    queue.assign(1, seed);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Index v = queue[i];
      mesh.for_each_neighbor(v, [&](Index u) {
        if (is_found[u]) return;
        if (!is_reached_from(u, mesh.hint(v))) missed.push_back(u);
        is_found[u] = 1;
        queue.push_back(u);
      });
    }
  }
  for (const Index v : missed) {
    bool is_reached = false;
    mesh.for_each_neighbor(v, [&](Index u) {
      is_reached = is_reached || is_reached_from(v, mesh.hint(u));
    });
    if (!is_reached) search(v);
  }
}

// The same where the surface is a copy of the mesh as it is.
inline void start_where_vertices_are(Remeshing_mesh& mesh)
{
  for (Remeshing_mesh::Index v = 0; v < Remeshing_mesh::Index(mesh.number_of_vertex_slots()); ++v)
    mesh.hint(v) = mesh.face(mesh.first(v));
}

// The surface's faces by the input faces that they are.
inline std::vector<Remeshing_mesh::Index> faces_by_source(const Reference_surface& surface)
{
  std::vector<Remeshing_mesh::Index> result(surface.number_of_faces());
  for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(result.size()); ++f)
    result[surface.face_record(f).source] = f;
  return result;
}

template <class Functor>
using Reference_surface_of = decltype(std::declval<const Functor&>().reference_surface());
template <class Functor, class = void>
struct Has_reference_surface : std::false_type {};
template <class Functor>
struct Has_reference_surface<Functor, std::void_t<Reference_surface_of<Functor>>> : std::true_type {};

template <class Functor>
using Mls_surface_of = decltype(std::declval<const Functor&>().mls_surface());
template <class Functor, class = void>
struct Has_mls_surface : std::false_type {};
template <class Functor>
struct Has_mls_surface<Functor, std::void_t<Mls_surface_of<Functor>>> : std::true_type {};

template <class Functor>
const Functor& referred(const Functor& functor) { return functor; }
template <class Functor>
const Functor& referred(const std::reference_wrapper<Functor>& functor) { return functor.get(); }

// The default: facets where they are at most twice as long as the target, for they are what the result is measured
// against; the MLS surface where they are three times as long, for there they would show; smooth between. Where hardly any
// facet is that long, the run is one at the input's own length, and the facets rule everywhere; so they do on CAD models,
// where they are what the design was approximated by.
struct Input_kind
{
  bool is_cad;                   // the dihedral angles tell a CAD model
  bool has_found_features;       // its sharp edges were found by themselves, and are constrained
  Remeshing_report::Features features;
  std::size_t feature_edges;
};

struct Default_surface
{
  static constexpr double FACET_RATIO = 2, SMOOTH_RATIO = 3;
  static constexpr double LEAST_SHARE = 0.05;       // of the area

  Default_surface(const Remeshing_mesh& mesh, double target, const Input_kind& kind)
    : facets(mesh), face_of_source(faces_by_source(facets)), target_length(target)
  {
    if (!(target > 0) || kind.is_cad) return;
    double all = 0, long_ones = 0;
    for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(facets.number_of_faces()); ++f) {
      const double area = length(facets.cross_product(f));
      all += area;
      if (mean_edge_length(facets, f) > FACET_RATIO * target) long_ones += area;
    }
    if (!(long_ones > LEAST_SHARE * all)) return;
    const std::vector<Remeshing_mesh::Index> creases =
      kind.has_found_features ? std::vector<Remeshing_mesh::Index>() : find_features(mesh);
    smooth.emplace(facets, creases, FACET_RATIO * target);
  }
  Default_surface(const Default_surface&) = delete;     // `smooth` refers to `facets`
  Default_surface& operator=(const Default_surface&) = delete;
  Surface_projection projection() const
  {
    return {facets, 1, smooth ? &*smooth : nullptr, FACET_RATIO * target_length, SMOOTH_RATIO * target_length, nullptr, &face_of_source};
  }

  // Bends the curves of the mesh into those of the surface, where the mesh as a whole is refined by so much: a border is
  // measured against its polyline before that. Edges that the user marked stay straight.
  void bend(Input_curves& curves, double mean_length, const Remeshing_mesh& mesh, const Input_kind& kind) const
  {
    if (!smooth || mean_length < SMOOTH_RATIO * target_length) return;
    const Surface_projection blend = projection();
    curves.bend([&](Remeshing_mesh::Index h) {
      const Remeshing_mesh::Index o = facets.opposite(h);
      double share = blend.share_of_mls(smooth->mean_edge_length(h >> 2));
      if (o >= 0) share = (share + blend.share_of_mls(smooth->mean_edge_length(o >> 2))) / 2;
      if (mesh.is_constrained(h) && !kind.has_found_features) return std::array<Vector3, 2>{};
      std::array<Vector3, 2> offsets = smooth->curve_offsets(h);
      for (Vector3& d : offsets) d = share * d;
      return offsets;
    });
  }

  // The area of the surface over that of the facets.
  double area_ratio() const
  {
    if (!smooth) return 1;
    double flat = 0, curved = 0;
    for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(facets.number_of_faces()); ++f) {
      const double area = length(facets.cross_product(f)) / 2;
      flat += area;
      curved += smooth->mean_edge_length(f) > FACET_RATIO * target_length ? smooth->area(f) : area;
    }
    return curved / flat;
  }

  Reference_surface facets;
  std::vector<Remeshing_mesh::Index> face_of_source;
  std::optional<Mls_surface> smooth;
  double target_length;
};

// The surface of the paper: MLS on the up-sampled facets.
inline std::function<Vector3(const Vector3&)> paper_surface(const Reference_surface& facets,
                                                            const std::vector<Remeshing_mesh::Index>& creases)
{
#ifdef CGAL_EIGEN3_ENABLED
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  std::vector<std::pair<Point, Vector>> samples;
  for_each_sample(Mls_surface(facets, creases), [&](const Surface_sample& s) {
    samples.emplace_back(Point(s.point.x, s.point.y, s.point.z), Vector(s.normal.x, s.normal.y, s.normal.z));
  });
  if (samples.empty()) return {};
  return [projector = Point_set_MLS_projector<Point>(samples)](const Vector3& q) {
    const Point p = projector.project(Point(q.x, q.y, q.z));
    return Vector3{p.x(), p.y(), p.z()};
  };
#else
  (void)facets; (void)creases;
  refuse(REMESHING, "Recipe::Surface::paper, as in Recipe::paper(), needs Eigen: define CGAL_EIGEN3_ENABLED");
#endif
}

// Runs the remesher with the projector that the functor asks for. A wanted number of faces is one of the surface that
// the result lies on: the target length follows its area.
template <class ConcurrencyTag, class Parameters, class Exchange, class Run>
Remeshing_report run_with_projector(const Parameters& parameters, const Exchange& exchange, Remeshing_mesh& mesh,
                                    const Input_kind& kind, Input_curves& curves, double& target, const Run& run)
{
  using Vertex = std::decay_t<decltype(exchange.input_vertices()[0])>;
  using Point_3 = typename boost::property_traits<decltype(parameters.vertex_point_map)>::value_type;
  const auto& functor = referred(parameters.projection_functor);
  using Functor = std::decay_t<decltype(functor)>;
  if (!parameters.does_project) return run(No_projection());
  if constexpr (std::is_same<Functor, No_map>::value) {
    if (parameters.recipe.surface == Recipe::Surface::paper) {
      const Reference_surface facets(mesh);
      const std::vector<Remeshing_mesh::Index> face_of_source = faces_by_source(facets);
      const auto rule = paper_surface(facets, find_features(mesh));
      start_where_vertices_are(mesh);
      Surface_projection projection{facets};
      projection.face_of_source = &face_of_source;
      if (rule) projection.rule = &rule;
      return run(projection);
    }
    const Default_surface surface(mesh, target, kind);
    start_where_vertices_are(mesh);
    surface.bend(curves, mean_edge_length(mesh), mesh, kind);
    if (parameters.schedule.wanted_faces > 0) target *= std::sqrt(surface.area_ratio());
    return run(surface.projection());
  } else if constexpr (Has_reference_surface<Functor>::value) {
    const Reference_surface& surface = functor.reference_surface();
    Surface_projection projection{surface, mesh.unit() / surface.unit()};
    find_hints(mesh, projection);
    if constexpr (Has_mls_surface<Functor>::value) projection.mls = &functor.mls_surface();
    return run(projection);
  } else if constexpr (std::is_invocable_r<Point_3, const Functor&, const Point_3&>::value)
    return run(Point_functor_projection<Functor, Point_3>{functor, mesh.unit()});
  else {
    static_assert(std::is_invocable_r<Point_3, const Functor&, Vertex>::value,
                  "projection_functor: expected a functor `Point_3 operator()(vertex_descriptor) const`, as in "
                  "Polygon_mesh_processing, or `Point_3 operator()(const Point_3&) const`.");
    const Vertex_functor_projection<Functor, Vertex, decltype(parameters.vertex_point_map)> projection(
      functor, exchange.input_vertices().front(), parameters.vertex_point_map, mesh.unit());
    const Remeshing_report report = run(projection);
    projection.restore();
    return report;
  }
}

template <class PatchMap, class Faces>
auto read_patches(const PatchMap& fpm, const Faces& faces)
{
  if constexpr (std::is_same<PatchMap, No_map>::value) {
    (void)fpm; (void)faces;
    return No_map();
  } else {
    std::vector<typename boost::property_traits<PatchMap>::value_type> patches;
    patches.reserve(faces.size());
    for (const auto& f : faces) patches.push_back(get(fpm, f));
    return patches;
  }
}

inline std::size_t count_features(const Remeshing_mesh& mesh)
{
  std::size_t n = 0;
  for (Remeshing_mesh::Index h = 0; h < 4 * Remeshing_mesh::Index(mesh.number_of_face_slots()); ++h)
    n += mesh.corner(h) < 3 && mesh.is_constrained(h) && (mesh.is_border(h) || mesh.opposite(h) > h);
  return n;
}

// Features are found by themselves where nothing is marked, and where the surface stays the input's: a functor of the
// user's may lead to any other, a sphere for an icosahedron.
template <class Parameters>
Input_kind find_and_mark_features(Remeshing_mesh& mesh, double length, const Parameters& parameters)
{
  using Functor = std::decay_t<decltype(referred(parameters.projection_functor))>;
  constexpr bool keeps_surface = std::is_same<Functor, No_map>::value || Has_reference_surface<Functor>::value;
  using Features = Remeshing_report::Features;
  Input_kind kind{false, false, Features::none, count_features(mesh)};
  if (kind.feature_edges > 0) kind.features = Features::marked;
  if (!keeps_surface || parameters.recipe.surface == Recipe::Surface::paper) return kind;
  Feature_detector detector(mesh, length);
  kind.is_cad = detector.is_cad();
  kind.has_found_features = parameters.constraint_settings.finds_features;
  if (!kind.has_found_features) return kind;
  const std::vector<Remeshing_mesh::Index> found = detector.features();
  for (const Remeshing_mesh::Index h : found) mark_feature(mesh, h);
  if (!found.empty()) kind.features = kind.is_cad ? Features::all_sharp_edges : Features::outstanding_edges;
  kind.feature_edges = count_features(mesh);
  return kind;
}

template <class ConcurrencyTag, class FaceRange, class Length, class TriangleMesh, class Parameters>
Remeshing_report remesh_range(const FaceRange& range, const Length& length, TriangleMesh& tmesh,
                              Parameters& parameters)
{
  using Vpm = decltype(parameters.vertex_point_map);
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  check_recipe(parameters.recipe);
  if (range.begin() == range.end()) {
    if constexpr (!std::is_same<Length, Face_count>::value) check_length(CGAL::to_double(length), 0, 0);
    return {};
  }
  Mesh_exchange<TriangleMesh, Vpm> exchange(range, tmesh, parameters.vertex_point_map, REMESHING);
  const double total_length = total_edge_length(exchange.mesh());
  double target = target_length(length, exchange.mesh(), total_length);
  if (parameters.schedule.iterations == 0) return {};
  if constexpr (std::is_same<Length, Face_count>::value) parameters.schedule.wanted_faces = length.value;

  mark_constraints(exchange, tmesh, parameters.edge_is_constrained_map, parameters.vertex_is_constrained_map,
                   parameters.face_patch_map, parameters.constraint_settings);
  const double mean_length = total_length / (1.5 * double(exchange.input_faces().size()));
  const Input_kind kind = find_and_mark_features(exchange.mesh(), (std::max)(target, mean_length), parameters);
  lock_corners(exchange.mesh(), kind.is_cad ? 0. : target);    // designed curves are not jagged
  const auto patches = read_patches(parameters.face_patch_map, exchange.input_faces());
  Remeshing_mesh mesh = exchange.take_mesh();
  mesh.renumber<ConcurrencyTag>(morton_order(mesh));
  Input_curves curves(mesh);

  Remeshing_report report = run_with_projector<ConcurrencyTag>(parameters, exchange, mesh, kind, curves, target,
    [&](const auto& projector) {
      using Context = Remeshing_context<Vertex, decltype(parameters.split_policy), decltype(parameters.collapse_policy),
                                        decltype(parameters.flip_policy), std::decay_t<decltype(projector)>,
                                        std::decay_t<decltype(parameters.visitor)>>;
      Context context{mesh, parameters.recipe, curves, exchange.input_vertices(),
                      boost::graph_traits<TriangleMesh>::null_vertex(), parameters.split_policy,
                      parameters.collapse_policy, parameters.flip_policy, projector, parameters.visitor,
                      parameters.may_collapse_constraints, target, kind.is_cad ? parameters.recipe.grading : 0., Grading()};
      return Remesher<ConcurrencyTag, Context>(context, parameters.schedule).run();
    });

  report.features = kind.features;
  report.feature_edges = kind.feature_edges;
  exchange.write(mesh);
  write_constraints(exchange, mesh, tmesh, parameters.edge_is_constrained_map, parameters.face_patch_map, patches);
  return report;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESH_RANGE_H
