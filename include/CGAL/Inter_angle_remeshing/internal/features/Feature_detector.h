// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTOR_H

#include <CGAL/Inter_angle_remeshing/internal/features/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_network.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_pruning.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Model_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Narrow_strips.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Outstanding_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Rounded_edge_finder.h>
#include <CGAL/Inter_angle_remeshing/internal/features/dense_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/features/fine_relief.h>
#include <CGAL/Inter_angle_remeshing/internal/features/planar_rims.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

// Which edges of a mesh are sharp, with nothing known but the mesh. On a CAD model, which shows in its dihedral angles,
// every edge of 40 degrees and more is. Elsewhere the normals are filtered first; what then stands out of its surroundings
// and continues for some length is a feature, and so are the rims of planar parts, smooth curves, creases of coarse models, and fillets.

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

  // Features shorter than a few times `target_length`, or than a few edges of the mesh, are none: of those that the mesh has on its own,
  // a greater length leaves some. With 0 they are those that the mesh has on its own.
  Feature_detector(const Remeshing_mesh& mesh, double target_length)
    : mesh_(mesh), own_length_(mean_edge_length(mesh)), scale_(target_length),
      target_length_(target_length > 0 ? target_length : own_length_), length_((std::max)(target_length_, own_length_)),
      normals_(mesh), kind_(normals_, own_length_), unfiltered_(normals_.all())
  {}

  Feature_detector(const Feature_detector&) = delete;     // `kind_` refers to `normals_`
  Feature_detector& operator=(const Feature_detector&) = delete;

  const Model_kind& kind() const { return kind_; }

  // One half-edge of each feature; low steps are told by the target lengths, by face.
  std::vector<Index> features(const std::vector<double>& lengths)
  {
    if (kind_.has_voxel_stairs()) return {};
    if (kind_.is_cad()) return without_narrow_strips(kind_.sharp_edges(Model_kind::CAD_ANGLE), lengths);
    const std::vector<Index> rims = planar_rims(normals_, kind_.sharp_edges());
    const std::vector<Index> curves = united(sharp_rings(), without_narrow_strips(kind_.smooth_curves(), lengths));
    Outstanding_edges outstanding(normals_, own_length_, kind_.sharp_edges());
    if (outstanding.are_none() && rims.empty() && curves.empty()) return {};
    std::vector<Index> found = united(outstanding.find(), united(rims, curves));
    const std::vector<Index> certain = united(long_rims(rims, lengths), curves);
    found = long_chains(found, certain, own_length_);
    return length_ > own_length_ ? long_chains(found, certain, length_) : found;
  }

  // What edges of the target lengths, by face, would cut off: the same, the creases of a model that is no CAD model and coarse for the
  // target length, and the fillets of parts, of at most so many target lengths. On CAD models, and on those with smooth curves, without
  // what is a relief of this density.
  Found_features features_for(const std::vector<double>& lengths, double fillet_width, double relief_density)
  {
    if (kind_.has_voxel_stairs()) return {};
    const bool is_cad = kind_.is_cad();
    const bool may_have_fillets = fillet_width > 0 && (is_cad || normals_.planar_share() >= LEAST_PLANAR_SHARE);
    Found_features result;
    std::vector<Index>& found = result.edges;
    found = features(lengths);
    for (const Index h : kind_.creases())
      if (is_coarse(h, lengths[h >> 2]) && is_coarse(mesh_.opposite(h), lengths[mesh_.opposite(h) >> 2]))
        found.push_back(h);
    make_unique(found);
    Rounded_edges rounded;
    if (may_have_fillets) rounded = Rounded_edge_finder(mesh_, unfiltered_, found, lengths).find(fillet_width);
    // Not before: what goes is no fillet either.
    if (is_cad || !kind_.smooth_curves().empty()) drop_fine_relief(found, lengths, relief_density);
    const std::size_t others = found.size();
    found.insert(found.end(), rounded.edges.begin(), rounded.edges.end());
    if (is_cad || rounded.edges.empty() || is_bent_network(found))
      result.rounded = std::move(rounded);
    else found.resize(others);
    make_unique(found);
    return result;
  }

  // One half-edge of each edge of the crests of thin bodies, of at most so many target lengths, by face; none in noise, or on stairs.
  std::vector<Index> crests(const std::vector<Index>& features, std::vector<double> lengths, double crest_width) const
  {
    if (!(crest_width > 0) || kind_.has_voxel_stairs() || kind_.saddle_excess() > 0) return {};
    return Rounded_edge_finder(mesh_, unfiltered_, features, std::move(lengths)).find_crests(crest_width);
  }

private:
  static constexpr double NARROW = 0.05;                // strip, in lengths
  static constexpr double LEAST_RIM = 5;                // of a planar part, in target lengths
  // Rings of sharp edges have so many mean edge lengths, and target lengths; there are at most so many of their edges for each face.
  static constexpr double LEAST_RING = 5, LEAST_HOLE = 3, MOST_RINGS = 0.2;
  // Reliefs are looked for at so many lengths from the target length down, each shorter by this factor: halves leap over the few
  // lengths that are long beside a thread's height and short beside the screw.
  static constexpr int RELIEF_SCALES = 9;
  static constexpr double RELIEF_RATIO = 0.7;
  // A model is coarse where creases, and the altitudes of the faces over them, have so many target lengths.
  static constexpr double COARSE = 2;
  // A part without sharp edges shows in the planar part of its area.
  static constexpr double LEAST_PLANAR_SHARE = 0.75;

  // Whether the edge of h is long, and its face high over it, beside edges of the target length.
  bool is_coarse(Index h, double target_length) const
  {
    const double l = std::sqrt(mesh_.squared_edge_length(h)), least = COARSE * target_length;
    return target_length > 0 && l >= least && normals_.doubled_area(h >> 2) >= least * l;
  }

  // Leaves one half-edge of each edge, sorted.
  void make_unique(std::vector<Index>& edges) const
  {
    for (Index& h : edges) h = (std::min)(h, mesh_.opposite(h));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }

  // Both are sorted.
  static std::vector<Index> united(const std::vector<Index>& a, const std::vector<Index>& b)
  {
    std::vector<Index> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  // Whether these edges are those of a part with fillets.
  bool is_bent_network(const std::vector<Index>& edges) const
  {
    Feature_graph graph(mesh_, own_length_, edges);
    return Feature_network(graph).is_bent();
  }

  // Whether edges of the target lengths, by face, follow the edge of h, and there is room for some on both sides: no relief is that large.
  bool is_between_large_faces(Index h, const std::vector<double>& lengths) const
  {
    const auto is_large_over = [&](Index g) {
      const double l = lengths[g >> 2];
      return mesh_.squared_edge_length(g) >= l * l && mesh_.altitude(g) >= l;
    };
    return is_large_over(h) && is_large_over(mesh_.opposite(h));
  }

  // The edges of rings, sorted: sharp all around, they are where two surfaces meet, as where a hole was drilled into what has grown.
  // Where there are rings everywhere, it is corrugated.
  std::vector<Index> sharp_rings() const
  {
    Feature_graph graph(mesh_, length_);
    for (const Index h : kind_.sharp_edges()) graph.add(h, normals_.angle(h));
    Feature_pruning(graph).keep_rings((std::max)(LEAST_RING * own_length_, LEAST_HOLE * target_length_) / length_);
    std::vector<Index> edges = graph.edges();
    if (double(edges.size()) > MOST_RINGS * double(mesh_.number_of_face_slots())) edges.clear();
    return edges;
  }

  // Of these edges, the certain ones, and those that form chains and components that are features at the scale of the length.
  std::vector<Index> long_chains(const std::vector<Index>& edges, const std::vector<Index>& certain, double length) const
  {
    Feature_graph graph(mesh_, length);
    for (const Index h : edges) graph.add(h, normals_.angle(h), std::binary_search(certain.begin(), certain.end(), h));
    if (kind_.has_jagged_chamfers()) Feature_pruning(graph).prune_part();
    else Feature_pruning(graph).prune();
    return graph.edges();
  }

  // Of the edges of rims, sorted, those that are certain to be features: the end of a long thin pipe is small beside the pipe's edges.
  std::vector<Index> long_rims(const std::vector<Index>& rims, const std::vector<double>& lengths) const
  {
    Feature_graph graph(mesh_, target_length_);
    for (const Index h : rims) graph.add(h, normals_.turn(h));
    graph.drop_short_components(LEAST_RIM);
    drop_sides_of_strips(graph, target_length_, target_length_, lengths);
    return graph.edges();
  }

  // Of strips that are too narrow for the first length, certainly where they are for the second one.
  static void drop_sides_of_strips(Feature_graph& graph, double length, double certain_length, const std::vector<double>& lengths)
  {
    Narrow_strips(graph, NARROW * length, NARROW * certain_length).drop_sides([&](Index f) { return NARROW * lengths[f]; });
  }

  // Of these edges, those that are left when no two chains are the sides of a strip too narrow for the length, or of a step too low for
  // the target lengths, by face.
  std::vector<Index> without_narrow_strips(const std::vector<Index>& edges, const std::vector<double>& lengths) const
  {
    Feature_graph graph(mesh_, length_);
    for (const Index h : edges) graph.add(h, normals_.turn(h));
    drop_sides_of_strips(graph, length_, scale_, lengths);
    return graph.edges();
  }

  // Takes out what is a relief of this density beside edges of these lengths, by face. What is too fine for a length is too fine for a
  // longer one, in whose cube a small part may lie as a whole, with normals to all sides.
  void drop_fine_relief(std::vector<Index>& edges, const std::vector<double>& lengths, double density) const
  {
    if (edges.empty() || std::isinf(density) || !(*std::min_element(lengths.begin(), lengths.end()) > 0)) return;
    std::vector<double> densities(edges.size(), 0), shorter = lengths;
    for (int scale = 0; scale < RELIEF_SCALES && !(*std::min_element(densities.begin(), densities.end()) > density); ++scale) {
      Fine_relief(mesh_, unfiltered_, shorter).raise(densities, edges, density);
      for (double& l : shorter) l *= RELIEF_RATIO;
    }
    if (!(*std::max_element(densities.begin(), densities.end()) > density)) return;
    Feature_graph graph(mesh_, target_length_);
    for (const Index h : edges) {
      const double length_there = (std::min)(lengths[h >> 2], lengths[mesh_.opposite(h) >> 2]);
      graph.add(h, 0, is_between_large_faces(h, lengths), target_length_ / length_there);
    }
    cut_out_dense_edges(graph, densities, density);
    edges = graph.edges();
  }

  const Remeshing_mesh& mesh_;
  double own_length_, scale_, target_length_, length_;     // scale_: the target length, 0 without one
  Face_normals normals_;
  Model_kind kind_;
  std::vector<Vector3> unfiltered_;      // normals
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FEATURE_DETECTOR_H
