// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURE_DETECTION_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURE_DETECTION_H

#include <CGAL/Inter_angle_remeshing/internal/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/fine_relief.h>
#include <CGAL/Inter_angle_remeshing/internal/rounded_edges.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

// Which edges of a mesh are sharp, with nothing known but the mesh. On a CAD model, which shows in its dihedral angles,
// every edge of 40 degrees and more is. Elsewhere the normals are filtered first; what then stands out of its surroundings
// and continues for some length is a feature.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The features of a run: one half-edge of each, sorted; among them those of fillets.
struct Found_features
{
  std::vector<Remeshing_mesh::Index> edges;
  Rounded_edges rounded;
};

class Feature_detector
{
public:
  using Index = Remeshing_mesh::Index;

  // Features shorter than a few times `length`, or than a few edges of the mesh, are none: of those that the mesh has on its own, a
  // greater length leaves some.
  Feature_detector(const Remeshing_mesh& mesh, double length)
    : mesh_(mesh), length_(length), own_length_(mean_edge_length(mesh))
  {
    find_normals();
    look_at_edges();
  }

  bool is_cad() const { return is_cad_; }
  // The part of the vertices that are saddles of sharp edges, where two and more ridges meet two and more grooves, beyond that of
  // clean models: noise makes them everywhere, parts and what has grown have few.
  double saddle_excess() const
  {
    const double share = double(saddles_) / double(mesh_.number_of_vertex_slots());
    return saddles_ < LEAST_NOISY_SADDLES ? 0. : (std::max)(0., share - CLEAN_SHARE);
  }
  // One half-edge of each feature.
  std::vector<Index> features()
  {
    if (is_cad_) return without_narrow_strips(sharp_edges(CAD_ANGLE));
    const std::vector<Index> rims = rims_of_planar_parts();
    find_active_faces();
    if (active_.empty() && rims.empty()) return {};
    for (int pass = 0; pass < BILATERAL_PASSES; ++pass) filter_normals();
    const std::vector<Index> outstanding = outstanding_edges();
    std::vector<Index> found;
    std::set_union(outstanding.begin(), outstanding.end(), rims.begin(), rims.end(), std::back_inserter(found));
    found = long_chains(found, long_rims(rims, own_length_), own_length_);
    return length_ > own_length_ ? long_chains(found, long_rims(rims, length_), length_) : found;
  }
  // What edges of a target length, which may be another one on every face, `target_length(f)`, would cut off: the same, the creases
  // of a model that is no CAD model and coarse for the target length, and the fillets of parts, of at most so many target lengths. On
  // CAD models, without what is a relief of this density.
  template <class Length>
  Found_features features(const Length& target_length, double fillet_width, double relief_density)
  {
    Found_features result;
    std::vector<Index>& found = result.edges;
    constexpr bool may_bend = true;
    const bool may_have_fillets = fillet_width > 0 && (is_cad_ || planar_share() >= LEAST_PLANAR_SHARE);
    std::vector<Vector3> unfiltered;
    if (may_have_fillets && !is_cad_) unfiltered = normal_;
    std::vector<double> lengths(mesh_.number_of_face_slots());
    for (Index f = 0; f < Index(lengths.size()); ++f) lengths[f] = target_length(f);
    found = features();
    for (const Index h : creases_)
      if (is_coarse(h, lengths[h >> 2]) && is_coarse(mesh_.opposite(h), lengths[mesh_.opposite(h) >> 2]))
        found.push_back(h);
    Rounded_edges rounded;
    if (may_have_fillets)
      rounded = Rounded_edge_finder(mesh_, is_cad_ ? normal_ : unfiltered, found, lengths).find(fillet_width);
    if (is_cad_) drop_fine_relief(found, std::move(lengths), relief_density);       // not before: what goes is no fillet either
    const std::size_t others = found.size();
    found.insert(found.end(), rounded.edges.begin(), rounded.edges.end());
    if (is_cad_ || rounded.edges.empty() || form_network(found, may_bend)) result.rounded = std::move(rounded);
    else found.resize(others);
    for (Index& h : found) h = (std::min)(h, mesh_.opposite(h));
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return result;
  }

private:
  // Dihedral angles in degrees.
  static constexpr double CAD_ANGLE = 40, MILD_ANGLE = 12, FLAT_ANGLE = 8, PLANAR_ANGLE = 0.5;
  static constexpr double LEAST_ANGLE = 30, FOLD_ANGLE = 150;
  static constexpr double SLIVER = 0.1;                 // altitude of a sliver, at most, over its longest edge
  // A candidate is this many times as sharp as three of the four other edges of its faces, before the filter.
  static constexpr double CANDIDATE_RATIO = 2.5;
  // An edge stands out when it is this many times as sharp as the median of the edges around it.
  static constexpr double OUTSTANDING = 3;
  static constexpr int BILATERAL_PASSES = 5;
  static constexpr double NORMAL_DEVIATION = 0.35;      // σ of the filter's weights, as a distance of unit normals
  static constexpr double LEAST_CANDIDATE_LENGTH = 4;   // of connected candidates, in lengths
  // Sharp edges that hang together are long with so many edge lengths, with this part of the root of the area, or as a ring of so
  // many edges, between which there are no sharp ones.
  static constexpr double LONG_COMPONENT = 8, LONG_PART = 0.25;
  static constexpr std::size_t LONG_RING = 9;
  // The edges in between may be so many times as long as sharp ones that form a network.
  static constexpr double MOST_MILD = 3.5;
  // Sharp edges are those of noise where so many of their vertices are saddles, and this part of all.
  static constexpr std::size_t LEAST_SADDLES = 50;
  static constexpr double NOISE_SHARE = 0.1;
  // Meshes with fewer of them, or with this part of their vertices, may be clean and coarse.
  static constexpr std::size_t LEAST_NOISY_SADDLES = 100;
  static constexpr double CLEAN_SHARE = 0.035;
  static constexpr double NARROW = 0.05;                // strip, in lengths
  // Reliefs are looked for at so many lengths from the target length down, each shorter by this factor: halves leap over the few
  // lengths that are long beside a thread's height and short beside the screw.
  static constexpr int RELIEF_SCALES = 9;
  static constexpr double RELIEF_RATIO = 0.7;
  // Edges of at least this angle are creases where they make up this part of the length of all edges, and the model is coarse there
  // where they, and the altitudes of the faces over them, have so many target lengths.
  static constexpr double CREASE_ANGLE = 70, CREASE_SHARE = 0.05, COARSE = 2;
  // A planar part has at least so many faces, and the area of so many squares of the mean edge. Its rim is that of a cut or a base
  // if this part of its length is this sharp: the terraces of isosurfaces of voxels meet at 45 degrees.
  static constexpr std::size_t LEAST_PLANAR_FACES = 12;
  static constexpr double LEAST_PLANAR_AREA = 1, RIM_ANGLE = 60, LEAST_RIM_SHARE = 0.5, LEAST_RIM = 5;    // lengths
  static constexpr int RINGS = 2;                       // around candidates that are filtered
  // A part without sharp edges shows in the planar part of its area.
  static constexpr double LEAST_PLANAR_SHARE = 0.75;

  static double cosine_of(double degrees) { return std::cos(degrees * (CGAL_PI / 180)); }

  void find_normals()
  {
    normal_.resize(mesh_.number_of_face_slots());
    area_.resize(normal_.size());
    for (Index f = 0; f < Index(normal_.size()); ++f) {
      const Vector3 &a = mesh_.position(mesh_.origin(4 * f)), &b = mesh_.position(mesh_.origin(4 * f + 1)),
                    &c = mesh_.position(mesh_.origin(4 * f + 2));
      const Vector3 n = triangle_cross(a, b, c);
      const double l = internal::length(n);
      area_[f] = float(l);
      if (!is_degenerate(n, a, b, c)) normal_[f] = (1 / l) * n;
    }
    std::vector<std::pair<Index, Vector3>> corrected;
    for (Index f = 0; f < Index(normal_.size()); ++f)
      if (const Index h = longest_edge(f); is_folded_sliver(f, h)) {
        const Index o = mesh_.opposite(h);
        corrected.emplace_back(f, o < 0 || is_folded_sliver(o >> 2, longest_edge(o >> 2)) ? Vector3() : normal_[o >> 2]);
      }
    for (const auto& [f, n] : corrected) normal_[f] = n;
  }

  Index longest_edge(Index f) const
  {
    Index longest = 4 * f;
    for (Index h = 4 * f + 1; h < 4 * f + 3; ++h)
      if (mesh_.squared_edge_length(h) > mesh_.squared_edge_length(longest)) longest = h;
    return longest;
  }

  // Whether face f, of which h is the longest edge, is thin and lies on a neighbour: where it looks says nothing about the surface.
  bool is_folded_sliver(Index f, Index h) const
  {
    if (area_[f] > SLIVER * mesh_.squared_edge_length(h)) return false;
    const double folded = cosine_of(FOLD_ANGLE);
    return cosine(4 * f) < folded || cosine(4 * f + 1) < folded || cosine(4 * f + 2) < folded;
  }

  // The cosine of the dihedral angle; 1 on the border and beside faces without a normal.
  double cosine(Index h) const
  {
    const Index o = mesh_.opposite(h);
    if (o < 0) return 1;
    const Vector3 &m = normal_[h >> 2], &n = normal_[o >> 2];
    return m == Vector3() || n == Vector3() ? 1. : dot(m, n);
  }
  double angle(Index h) const { return std::acos((std::max)(-1., (std::min)(1., cosine(h)))) * (180 / CGAL_PI); }

  template <class Function>
  void for_each_inner_edge(const Function& function) const
  {
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f)
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
        if (mesh_.opposite(h) > h) function(h);
  }

  // Whether the edge of h is long, and its face high over it, beside edges of the target length.
  bool is_coarse(Index h, double target_length) const
  {
    const double l = std::sqrt(mesh_.squared_edge_length(h)), least = COARSE * target_length;
    return target_length > 0 && l >= least && double(area_[h >> 2]) >= least * l;
  }

  // Those of the sharp edges that have at least this angle.
  std::vector<Index> sharp_edges(double degrees) const
  {
    const double bound = cosine_of(degrees);
    std::vector<Index> found;
    for (const Index h : sharp_edges_)
      if (cosine(h) <= bound) found.push_back(h);
    return found;
  }

  // The part of the area whose faces are not the only ones in their planes.
  double planar_share() const
  {
    const double planar = cosine_of(PLANAR_ANGLE);
    double all = 0, of_polygons = 0;
    for (Index f = 0; f < Index(area_.size()); ++f) {
      all += area_[f];
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
        if (mesh_.opposite(h) >= 0 && cosine(h) > planar) {
          of_polygons += area_[f];
          break;
        }
    }
    return all > 0 ? of_polygons / all : 0.;
  }

  // Whether the face of h is part of a planar polygon beyond h.
  bool is_in_polygon(Index h) const
  {
    const double planar = cosine_of(PLANAR_ANGLE);
    return (mesh_.opposite(mesh_.next(h)) >= 0 && cosine(mesh_.next(h)) > planar) ||
           (mesh_.opposite(mesh_.prev(h)) >= 0 && cosine(mesh_.prev(h)) > planar);
  }

  // CAD models have sharp edges and flat ones, and few in between; or these are between planar polygons, as on cylinders, cones
  // and other surfaces of revolution of few facets. A few sharp edges beside each other, as around a vertex that is folded over, are
  // no feature of a part. Where round parts are coarse, as after remeshing, many edges are in between: the sharp ones still form
  // a network then.
  void look_at_edges()
  {
    const double sharp = cosine_of(CAD_ANGLE), mild = cosine_of(MILD_ANGLE), flat = cosine_of(FLAT_ANGLE),
                 least = cosine_of(LEAST_ANGLE);
    double of_all = 0, of_sharp = 0, of_mild = 0, of_facets = 0, of_creases = 0;
    std::size_t flat_edges = 0, edges = 0;
    for_each_inner_edge([&](Index h) {
      const double c = cosine(h), l = std::sqrt(mesh_.squared_edge_length(h));
      ++edges;
      of_all += l;
      flat_edges += c > flat;
      if (c <= least) sharp_edges_.push_back(h);
      if (c > mild) return;
      (c <= sharp ? of_sharp : of_mild) += l;
      if (c > sharp && is_in_polygon(h) && is_in_polygon(mesh_.opposite(h))) of_facets += l;
    });
    const std::vector<Index> candidates = sharp_edges(CAD_ANGLE);
    const double of_long = length_in_long_components(candidates);
    count_saddles(candidates);
    const auto are_few_mild = [&](double length) { return of_mild - of_facets < 0.2 * length; };
    const auto is_cad_with = [&](double length) {
      return of_mild < 0.5 * length || (of_mild < 1.1 * length && 2 * flat_edges > edges) || are_few_mild(length);
    };
    is_cad_ = ((is_cad_with(of_sharp) && is_cad_with(of_long)) || (of_mild < MOST_MILD * of_long && form_network(candidates))) &&
              ((are_few_mild(of_sharp) && are_few_mild(of_long)) || !are_of_noise());
    if (is_cad_) return;
    creases_ = sharp_edges(CREASE_ANGLE);
    for (const Index h : creases_) of_creases += std::sqrt(mesh_.squared_edge_length(h));
    if (of_creases < CREASE_SHARE * of_all || are_of_noise()) creases_.clear();
  }

  // Whether many of the vertices of sharp edges are saddles.
  bool are_of_noise() const
  {
    return saddles_ >= LEAST_SADDLES && double(saddles_) > NOISE_SHARE * double(sharp_vertices_);
  }

  // Among the vertices of these edges.
  void count_saddles(const std::vector<Index>& edges)
  {
    struct Edges { int ridges = 0, grooves = 0; };
    std::vector<Edges> edges_at(mesh_.number_of_vertex_slots());
    for (const Index h : edges) {
      const Index v = mesh_.origin(h);
      const bool is_ridge = dot(normal_[h >> 2], mesh_.position(mesh_.apex(mesh_.opposite(h))) - mesh_.position(v)) < 0;
      for (const Index end : {v, mesh_.target(h)}) ++(is_ridge ? edges_at[end].ridges : edges_at[end].grooves);
    }
    for (const Edges& e : edges_at) {
      sharp_vertices_ += e.ridges + e.grooves > 0;
      saddles_ += e.ridges > 1 && e.grooves > 1;
    }
  }

  bool form_network(const std::vector<Index>& edges, bool may_bend = false) const
  {
    Feature_graph graph(mesh_, own_length_);
    for (const Index h : edges) graph.add(h, 0);
    return graph.is_network(may_bend);
  }

  // The length of these edges in components that are long beside the edges of the mesh, or beside the model.
  double length_in_long_components(const std::vector<Index>& edges) const
  {
    const double area = std::accumulate(area_.begin(), area_.end(), 0.) / 2;
    Feature_graph graph(mesh_, own_length_);
    for (const Index h : edges) graph.add(h, 0);
    graph.drop_short_components((std::min)(LONG_COMPONENT, LONG_PART * std::sqrt(area) / own_length_), LONG_RING);
    double sum = 0;
    for (const Index h : graph.edges()) sum += std::sqrt(mesh_.squared_edge_length(h));
    return sum;
  }

  // Of these edges, the certain ones, and those that form chains and components that are features at the scale of the length.
  std::vector<Index> long_chains(const std::vector<Index>& edges, const std::vector<Index>& certain, double length) const
  {
    Feature_graph graph(mesh_, length);
    for (const Index h : edges) graph.add(h, angle(h), std::binary_search(certain.begin(), certain.end(), h));
    graph.prune();
    return graph.edges();
  }

  // Of the edges of rims, sorted, those that are certain to be features at the scale of the length.
  std::vector<Index> long_rims(const std::vector<Index>& rims, double length) const
  {
    Feature_graph graph(mesh_, length);
    for (const Index h : rims) graph.add(h, angle(h));
    graph.drop_short_components(LEAST_RIM);
    graph.drop_sides_of_strips(NARROW * length);
    return graph.edges();
  }

  // Of these edges, those that are left when no two chains are the sides of a strip too narrow for the length.
  std::vector<Index> without_narrow_strips(const std::vector<Index>& edges) const
  {
    Feature_graph graph(mesh_, length_);
    for (const Index h : edges) graph.add(h, angle(h));
    graph.drop_sides_of_strips(NARROW * length_);
    return graph.edges();
  }

  // Takes out what is a relief of this density beside edges of these lengths, by face. What is too fine for a length is too fine for a
  // longer one, in whose cube a small part may lie as a whole, with normals to all sides.
  void drop_fine_relief(std::vector<Index>& edges, std::vector<double> lengths, double density) const
  {
    if (edges.empty() || std::isinf(density) || !(*std::min_element(lengths.begin(), lengths.end()) > 0)) return;
    std::vector<double> densities(edges.size(), 0);
    for (int scale = 0; scale < RELIEF_SCALES; ++scale) {
      const std::vector<double> found = Fine_relief(mesh_, normal_, lengths).densities(edges);
      for (std::size_t i = 0; i < edges.size(); ++i) densities[i] = (std::max)(densities[i], found[i]);
      for (double& l : lengths) l *= RELIEF_RATIO;
    }
    if (!(*std::max_element(densities.begin(), densities.end()) > density)) return;
    Feature_graph graph(mesh_, length_);
    for (const Index h : edges) graph.add(h, 0);
    graph.cut_out(densities, density);
    edges = graph.edges();
  }

  void add_rim_of_planar_part(Index first, std::vector<char>& is_seen, std::vector<Index>& rim) const;
  std::vector<Index> rims_of_planar_parts() const;
  // The faces that the filter must look at: some rings around connected edges that are sharp over some length.
  void find_active_faces();
  bool is_candidate(Index h) const;
  void filter_normals();
  Vector3 filtered_normal(Index f) const;
  std::vector<Index> outstanding_edges();
  double noise(Index v);
  double mean_noise(Index v);

  const Remeshing_mesh& mesh_;
  double length_, own_length_;
  bool is_cad_;
  std::size_t sharp_vertices_ = 0, saddles_ = 0;       // vertices of edges of CAD_ANGLE, and those of them that are saddles
  std::vector<Vector3> normal_;        // unit, by face; zero where the face has none
  std::vector<float> area_;            // by face, twice
  std::vector<Index> sharp_edges_;     // of LEAST_ANGLE and more, before the filter
  std::vector<Index> creases_;         // of CREASE_ANGLE and more, before the filter; empty: too few
  std::vector<Index> active_;
  std::vector<char> is_active_;
  std::vector<float> noise_;           // by vertex, degrees; negative: not known yet
};

// Whether the planar part around a face, all of whose faces look the way that it does, is that of a cut or a base: nothing that has
// grown has any. Its faces are marked as seen; of the edges of its rim the sharp ones are added to `rim`.
inline void Feature_detector::add_rim_of_planar_part(Index first, std::vector<char>& is_seen, std::vector<Index>& rim) const
{
  const double planar = cosine_of(PLANAR_ANGLE), clear = cosine_of(RIM_ANGLE), least = cosine_of(LEAST_ANGLE);
  const std::size_t before = rim.size();
  std::vector<Index> part = {first};
  is_seen[first] = 1;
  double area = 0, length_of_rim = 0, length_of_clear = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    area += area_[part[i]] / 2;
    for (Index h = 4 * part[i]; h < 4 * part[i] + 3; ++h) {
      const Index o = mesh_.opposite(h);
      if (o < 0) continue;
      const Index f = o >> 2;
      if (dot(normal_[first], normal_[f]) > planar) {
        if (!is_seen[f]) part.push_back(f);
        is_seen[f] = 1;
      } else {
        const double c = cosine(h), l = std::sqrt(mesh_.squared_edge_length(h));
        length_of_rim += l;
        length_of_clear += c <= clear ? l : 0;
        if (c <= least) rim.push_back((std::min)(h, o));
      }
    }
  }
  if (part.size() < LEAST_PLANAR_FACES || area < LEAST_PLANAR_AREA * own_length_ * own_length_ ||
      length_of_clear < LEAST_RIM_SHARE * length_of_rim) rim.resize(before);
}

// The edges of all such rims, sorted.
inline std::vector<Feature_detector::Index> Feature_detector::rims_of_planar_parts() const
{
  std::vector<Index> result;
  std::vector<char> is_seen(mesh_.number_of_face_slots(), 0);
  for (const Index h : sharp_edges_)
    for (const Index side : {h, mesh_.opposite(h)})
      if (!is_seen[side >> 2]) add_rim_of_planar_part(side >> 2, is_seen, result);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

inline bool Feature_detector::is_candidate(Index h) const
{
  const Index o = mesh_.opposite(h);
  double around[4] = {cosine(mesh_.next(h)), cosine(mesh_.prev(h)), cosine(mesh_.next(o)), cosine(mesh_.prev(o))};
  std::sort(around, around + 4);
  return around[1] >= std::cos(std::acos((std::max)(-1., cosine(h))) / CANDIDATE_RATIO);
}

inline void Feature_detector::find_active_faces()
{
  Feature_graph candidates(mesh_, own_length_);
  for (const Index h : sharp_edges_)
    if (is_candidate(h)) candidates.add(h, 0);
  candidates.drop_short_components(LEAST_CANDIDATE_LENGTH);

  std::vector<char> is_reached(mesh_.number_of_vertex_slots(), 0);
  std::vector<Index> front;
  const auto reach = [&](Index v, std::vector<Index>& reached) {
    if (is_reached[v]) return;
    is_reached[v] = 1;
    reached.push_back(v);
  };
  for (const Index h : candidates.edges()) {
    reach(mesh_.origin(h), front);
    reach(mesh_.target(h), front);
  }
  is_active_.assign(mesh_.number_of_face_slots(), 0);
  for (int ring = 0; ring < RINGS; ++ring) {
    std::vector<Index> next;
    for (const Index v : front)
      mesh_.for_each_around(v, [&](Index h) {
        if (!is_active_[h >> 2]) {
          is_active_[h >> 2] = 1;
          active_.push_back(h >> 2);
        }
        reach(mesh_.target(h), next);
        reach(mesh_.apex(h), next);
      });
    front.swap(next);
  }
}

// The mean of the normals around, by area, and the less the more they differ: flat parts grow flat, edges stay. Faces that
// share an edge with f count twice.
inline Vector3 Feature_detector::filtered_normal(Index f) const
{
  const Vector3& n = normal_[f];
  Vector3 sum;
  for (Index h = 4 * f; h < 4 * f + 3; ++h)
    mesh_.for_each_around(mesh_.origin(h), [&](Index k) {
      const Vector3& m = normal_[k >> 2];
      const double x = squared_distance(m, n) / (2 * NORMAL_DEVIATION * NORMAL_DEVIATION);
      const double t = (std::max)(0., 1 - x / 8), t2 = t * t, t4 = t2 * t2;       // t⁸, nearly exp(-x)
      sum += (t4 * t4 * double(area_[k >> 2])) * m;
    });
  const double l = length(sum);
  return l > 0 ? (1 / l) * sum : n;
}

inline void Feature_detector::filter_normals()
{
  std::vector<Vector3> filtered;
  filtered.reserve(active_.size());
  for (const Index f : active_) filtered.push_back(normal_[f] == Vector3() ? Vector3() : filtered_normal(f));
  for (std::size_t i = 0; i < active_.size(); ++i) normal_[active_[i]] = filtered[i];
}

// The median, by length, of the dihedral angles at v and around its star, the two sharpest at v left out.
inline double Feature_detector::noise(Index v)
{
  if (noise_[v] >= 0) return noise_[v];
  std::vector<std::pair<double, double>> spokes, all;     // angle and length
  const auto entry = [&](Index h) { return std::make_pair(angle(h), std::sqrt(mesh_.squared_edge_length(h))); };
  mesh_.for_each_around(v, [&](Index h) {
    if (!mesh_.is_border(h)) spokes.push_back(entry(h));
    if (!mesh_.is_border(mesh_.next(h))) all.push_back(entry(mesh_.next(h)));
  });
  std::sort(spokes.rbegin(), spokes.rend());
  if (spokes.size() > 2) all.insert(all.end(), spokes.begin() + 2, spokes.end());
  std::sort(all.begin(), all.end());
  double total = 0, passed = 0, median = 0;
  for (const auto& [a, l] : all) total += l;
  for (const auto& [a, l] : all) {
    passed += l;
    median = a;
    if (passed >= total / 2) break;
  }
  return noise_[v] = float(median);
}

inline double Feature_detector::mean_noise(Index v)
{
  double sum = noise(v);
  int n = 1;
  mesh_.for_each_neighbor(v, [&](Index u) { sum += noise(u); ++n; });
  return sum / n;
}

inline std::vector<Feature_detector::Index> Feature_detector::outstanding_edges()
{
  noise_.assign(mesh_.number_of_vertex_slots(), -1);
  std::vector<Index> found;
  const double least = cosine_of(LEAST_ANGLE);
  for (const Index f : active_)
    for (Index h = 4 * f; h < 4 * f + 3; ++h)
      if (mesh_.opposite(h) > h && is_active_[mesh_.opposite(h) >> 2] && cosine(h) <= least &&
          angle(h) >= OUTSTANDING * 0.5 * (mean_noise(mesh_.origin(h)) + mean_noise(mesh_.target(h))))
        found.push_back(h);
  std::sort(found.begin(), found.end());
  return found;
}

// The features of a mesh at the scale of its own edges.
inline std::vector<Remeshing_mesh::Index> find_features(const Remeshing_mesh& mesh)
{
  return Feature_detector(mesh, mean_edge_length(mesh)).features();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURE_DETECTION_H
