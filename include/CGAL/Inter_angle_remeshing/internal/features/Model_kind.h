// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_MODEL_KIND_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_MODEL_KIND_H

#include <CGAL/Inter_angle_remeshing/internal/features/Face_normals.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_graph.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Feature_network.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Uneven_facets.h>
#include <CGAL/Inter_angle_remeshing/internal/features/jagged_chamfers.h>
#include <CGAL/Inter_angle_remeshing/internal/features/voxel_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What the dihedral angles tell about a model.
//
// CAD models have sharp edges and flat ones, and few in between; or these are between planar polygons, as on cylinders, cones and other
// surfaces of revolution of few facets. A few sharp edges beside each other, as around a vertex that is folded over, are no feature of a
// part. Where round parts are coarse, as after remeshing, many edges are in between: the sharp ones still form a network then, which tells
// less by its shape where much of the area is plane. Noise makes saddles of sharp edges everywhere, where two and more ridges meet two and
// more grooves, and leaves no planes beside them; parts and what has grown have few. Alpha wraps of parts have jagged chamfers instead of
// sharp edges: each of their rims as a curve of its own would be more than edges of the length of these can follow. Marching cubes around
// what is marked in a volume leave the stairs of its voxels, whose edges tell nothing about the object. What has grown and is as flat as a
// leaf has sharp edges at its rim, too, and flat ones elsewhere; but the sharp ones are a tangle, and over them the surface turns back,
// the more so, the more of them there are: a leaf of few faces has little but its rim. What is twisted, or a panel with noise, has sharp
// edges along smooth curves, and between these no flat ones. Parts that were simplified to some hundred or thousand faces have sharp edges
// wherever one looks; they, or their hulls, may also have sharp edges that are too few and too broken to tell a part, but few large
// facets.
class Model_kind
{
  using Index = Remeshing_mesh::Index;

  // Dihedral angles in degrees.
  static constexpr double MILD_ANGLE = 12, FLAT_ANGLE = 8;
  // Sharp edges that hang together are long with so many edge lengths, with this part of the root of the area that hangs together with
  // them, or as a ring of so many edges, between which there are no sharp ones.
  static constexpr double LONG_COMPONENT = 8, LONG_PART = 0.25;
  static constexpr std::size_t LONG_RING = 9;
  // Of a CAD model edges in between have less than these parts of the length of sharp ones: few do, not counting those between facets; or
  // some, with them; or many, where most of all edges are flat.
  static constexpr double FEW_MILD = 0.2, SOME_MILD = 0.5, MANY_MILD = 1.1;
  // Sharp edges are those of noise where so many of their vertices are saddles beside no planar polygon, and this part of all.
  static constexpr std::size_t LEAST_SADDLES = 50;
  static constexpr double NOISE_SHARE = 0.1;
  // Meshes with fewer of them, or with this part of their vertices, may be clean and coarse.
  static constexpr std::size_t LEAST_NOISY_SADDLES = 100;
  static constexpr double CLEAN_SHARE = 0.035;
  // Sharp edges are those of leaves where, of so many vertices at least, more than these parts are free ends, and free ends or junctions,
  // and over more than this part of their length the surface turns back, and more than they are of the length of all edges.
  static constexpr std::size_t LEAST_TANGLE = 100;
  static constexpr double LOOSE_SHARE = 0.005, TANGLE_SHARE = 0.1, TURNING_ANGLE = 120, TURNING_SHARE = 0.15;
  // Of a part that was simplified to at most so many sharp vertices, this part of the length of all edges is sharp; there are fewer edges
  // in between, and some planes, and hardly any sharp edges lead to a free end.
  static constexpr std::size_t MOST_SIMPLIFIED = 3000;
  static constexpr double SIMPLIFIED_SHARP_SHARE = 0.3, SIMPLIFIED_BETWEEN = 0.85, SIMPLIFIED_PLANAR_SHARE = 0.1,
                          SIMPLIFIED_RUN_SHARE = 0.9;
  // Edges of at least this angle are creases where they make up this part of the length of all edges.
  static constexpr double CREASE_ANGLE = 70, CREASE_SHARE = 0.05;
  // Smooth curves of creases are those of a part from so many roots of the area on: the rim of a hemisphere has two.
  static constexpr double LONG_CURVES = 2.5;
  // The part of the sharp edges of stairs of voxels that are rims of chamfers; voxels themselves have none. Where more than so many are
  // rims of thin walls, and so many turn to and fro, noise was marked: faces that do without its edges would cross each other. The edges
  // of vessels about as thick as a slice do not turn to and fro.
  static constexpr double CHAMFERED_STAIRS = 0.2, THIN_STAIRS = 0.1, NOISY_JAGS = 0.002;
  // Uneven facets say something where edges of at least LEAST_ANGLE have this part of the length of all edges: the tessellation of a smooth
  // body has facets as uneven. They are a part's where sharp ones have no more than this: more are in the way of each other.
  static constexpr double LEAST_BENT_SHARE = 0.008, MOST_SHARP_SHARE = 0.055;
  // Where simplification has taken the vertices off the grid, so many are rims of chamfers, and so many turn to and fro.
  static constexpr double SIMPLIFIED_CHAMFERS = 0.6, SIMPLIFIED_JAGS = 0.07;

public:
  // The angle from which on edges are sharp on CAD models, and on others.
  static constexpr double CAD_ANGLE = 40, LEAST_ANGLE = 30;

  // `own_length` is the mean edge length.
  Model_kind(const Face_normals& normals, double own_length)
    : normals_(normals), mesh_(normals.mesh()), own_length_(own_length)
  {
    look_at_edges();
  }

  bool is_cad() const { return is_cad_; }
  // Whether the first n faces might be a CAD model alone, by the edges between them. Not on a wrap, on stairs, on leaves or in noise, which
  // few faces do not tell from one. To be asked before the normals are filtered.
  bool may_be_cad(std::size_t n) const
  {
    if (has_voxel_stairs_ || has_jagged_chamfers_ || has_leaves_ || are_of_noise()) return false;
    const Lengths lengths = measure_edges(n, [](Index, double) {});
    return lengths.mild - lengths.facets < Feature_network::MOST_BETWEEN * lengths.sharp;
  }
  // Whether it would be a CAD model, had it sharp edges instead of jagged chamfers.
  bool has_jagged_chamfers() const { return has_jagged_chamfers_; }
  // Whether its sharp edges are those of the stairs that marching cubes leave. It is no CAD model then.
  bool has_voxel_stairs() const { return has_voxel_stairs_; }
  // Whether its faces are facets, large ones beside small ones, and no samples of a smooth surface.
  bool has_uneven_facets() const { return has_uneven_facets_; }
  // Of a model that is no CAD model, the sharp edges if nearly all of them are creases along smooth curves that end nowhere, and without
  // the others: between those of a twisted bar the edges of the facets are anything but flat. Sorted.
  const std::vector<Index>& smooth_curves() const { return smooth_curves_; }
  // One half-edge of each edge of LEAST_ANGLE and more; of those of at least this angle among them.
  const std::vector<Index>& sharp_edges() const { return sharp_edges_; }
  std::vector<Index> sharp_edges(double degrees) const
  {
    const double bound = cosine_of_degrees(degrees);
    std::vector<Index> found;
    for (const Index h : sharp_edges_)
      if (normals_.cosine(h) <= bound) found.push_back(h);
    return found;
  }
  // Of a model that is no CAD model; none where they are few.
  const std::vector<Index>& creases() const { return creases_; }

  // The part of the vertices that are saddles of sharp edges beyond that of clean models.
  double saddle_excess() const
  {
    const double share = double(saddles_) / double(mesh_.number_of_vertex_slots());
    return saddles_ < LEAST_NOISY_SADDLES ? 0. : (std::max)(0., share - CLEAN_SHARE);
  }

private:
  // What hangs together.
  struct Parts
  {
    std::vector<Index> part;             // by face
    std::vector<double> area;            // by part
    std::vector<double> planar_area;     // of these, of faces that are not the only ones in their planes
  };

  // Calls `function(h)` for one half-edge of each edge between the first n faces.
  template <class Function>
  void for_each_inner_edge(std::size_t n, const Function& function) const
  {
    for (Index f = 0; f < Index(n); ++f)
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
        if (mesh_.opposite(h) > h && mesh_.opposite(h) < Index(4 * n)) function(h);
  }

  // Whether the face of h is part of a planar polygon beyond h.
  bool is_in_polygon(Index h) const { return normals_.is_planar_at(mesh_.next(h)) || normals_.is_planar_at(mesh_.prev(h)); }

  void look_at_edges()
  {
    const double least = cosine_of_degrees(LEAST_ANGLE);
    const Lengths lengths = measure_edges(mesh_.number_of_face_slots(), [&](Index h, double cosine) {
      if (cosine <= least) sharp_edges_.push_back(h); });
    const std::vector<Index> candidates = sharp_edges(CAD_ANGLE);
    const Parts parts = find_parts();
    count_vertices(candidates);
    is_cad_ = looks_designed(lengths, candidates, parts);
    if (!is_cad_ && parts.area.size() == 1) look_at_facets(lengths);     // of a scene those of one part, however large, say nothing
    has_leaves_ = is_cad_ && are_of_leaves(lengths);
    is_cad_ = is_cad_ && !has_leaves_;
    const Jagged_chamfers chamfers(normals_, candidates);
    has_voxel_stairs_ = are_stairs(chamfers);
    has_jagged_chamfers_ = is_cad_ && !has_voxel_stairs_ && chamfers.are_there(own_length_) &&
                           (saddle_excess() > 0 || !chamfers.may_be_remeshed());
    is_cad_ = is_cad_ && !has_voxel_stairs_ && !has_jagged_chamfers_;
    if (is_cad_ || has_voxel_stairs_) return;
    find_creases(lengths.all);
    if (!has_jagged_chamfers_) find_smooth_curves(candidates, parts);
  }

  // The lengths of all edges, of sharp ones, of those of them over which the surface turns back, of those in between, and of these where
  // they are between facets.
  struct Lengths
  {
    double all = 0, sharp = 0, turning = 0, mild = 0, facets = 0;
    bool are_mostly_flat = false;        // more than half of the edges, by number
  };

  // Of a model that does not look designed otherwise.
  void look_at_facets(const Lengths& lengths)
  {
    if (length_of(sharp_edges_) < LEAST_BENT_SHARE * lengths.all) return;
    const Uneven_facets facets(normals_);
    has_uneven_facets_ = facets.are_there();
    is_cad_ = facets.are_few() && lengths.sharp <= MOST_SHARP_SHARE * lengths.all;
  }

  // Those between the first n faces. Calls `function(h, c)` for each of these edges, with the cosine of its dihedral angle.
  template <class Function>
  Lengths measure_edges(std::size_t n, const Function& function) const
  {
    const double sharp = cosine_of_degrees(CAD_ANGLE), mild = cosine_of_degrees(MILD_ANGLE), flat = cosine_of_degrees(FLAT_ANGLE),
                 turning = cosine_of_degrees(TURNING_ANGLE);
    Lengths result;
    std::size_t flat_edges = 0, edges = 0;
    for_each_inner_edge(n, [&](Index h) {
      const double c = normals_.cosine(h), l = std::sqrt(mesh_.squared_edge_length(h));
      ++edges;
      result.all += l;
      flat_edges += c > flat;
      function(h, c);
      if (c > mild) return;
      (c <= sharp ? result.sharp : result.mild) += l;
      if (c <= turning) result.turning += l;
      if (c > sharp && is_in_polygon(h) && is_in_polygon(mesh_.opposite(h))) result.facets += l;
    });
    result.are_mostly_flat = 2 * flat_edges > edges;
    return result;
  }

  // Whether the dihedral angles are those of a CAD model, whatever its sharp edges look like.
  bool looks_designed(const Lengths& lengths, const std::vector<Index>& candidates, const Parts& parts) const
  {
    const double of_long = length_in_long_components(candidates, parts);
    const auto hold_of_both = [&](const auto& condition) { return condition(lengths.sharp) && condition(of_long); };
    if (lengths.mild < SIMPLIFIED_BETWEEN * of_long && looks_simplified(lengths, candidates, parts)) return true;

    const auto are_few_mild = [&](double length) { return lengths.mild - lengths.facets < FEW_MILD * length; };
    if (hold_of_both(are_few_mild)) return true;
    if (are_of_noise()) return false;

    return hold_of_both([&](double length) {
             return are_few_mild(length) || lengths.mild < SOME_MILD * length ||
                    (lengths.mild < MANY_MILD * length && lengths.are_mostly_flat);
           }) || form_network(lengths.mild, of_long, candidates, parts);
  }

  bool form_network(double mild, double of_long, const std::vector<Index>& edges, const Parts& parts) const
  {
    if (mild >= Feature_network::MOST_BETWEEN_PLANES * of_long) return false;
    Feature_graph graph(mesh_, own_length_, edges);
    return Feature_network(graph).is_network(planar_share(parts), mild / of_long);
  }

  // Whether there are so many sharp edges beside planes that simplification has brought together what was a part's, tangle as they may.
  // What has grown, simplified as far, hardly has planes.
  bool looks_simplified(const Lengths& lengths, const std::vector<Index>& candidates, const Parts& parts) const
  {
    if (sharp_vertices_ > MOST_SIMPLIFIED || lengths.sharp < SIMPLIFIED_SHARP_SHARE * lengths.all || turns_back(lengths) ||
        planar_share(parts) < SIMPLIFIED_PLANAR_SHARE) return false;
    Feature_graph graph(mesh_, own_length_, candidates);
    graph.drop_trees();
    return graph.length_left() >= SIMPLIFIED_RUN_SHARE * lengths.sharp;
  }

  void find_creases(double length_of_all)
  {
    creases_ = sharp_edges(CREASE_ANGLE);
    if (length_of(creases_) < CREASE_SHARE * length_of_all || are_of_noise()) creases_.clear();
  }

  // Those of each part are as sharp and as long together.
  void find_smooth_curves(const std::vector<Index>& edges, const Parts& parts)
  {
    Feature_graph graph(mesh_, own_length_, edges);
    if (are_of_noise() || !Feature_network(graph).is_smooth()) return;
    const std::vector<Index> curves = graph.edges();
    std::vector<double> length(parts.area.size(), 0), turns(parts.area.size(), 0);      // by part
    for (const Index h : curves) {
      const double l = std::sqrt(mesh_.squared_edge_length(h));
      length[parts.part[h >> 2]] += l;
      turns[parts.part[h >> 2]] += l * normals_.angle(h);
    }
    for (const Index h : curves) {
      const Index k = parts.part[h >> 2];
      if (turns[k] >= CREASE_ANGLE * length[k] && length[k] >= LONG_CURVES * std::sqrt(parts.area[k])) smooth_curves_.push_back(h);
    }
  }

  bool are_stairs(const Jagged_chamfers& chamfers) const
  {
    const double share = chamfers.chamfer_share();
    if (share < CHAMFERED_STAIRS || (chamfers.wall_share() > THIN_STAIRS && chamfers.jagged_share() >= NOISY_JAGS)) return false;
    return Voxel_surface(mesh_, own_length_).is_one() ||
           (is_cad_ && !chamfers.tell_nothing() && share >= SIMPLIFIED_CHAMFERS && chamfers.jagged_share() >= SIMPLIFIED_JAGS);
  }

  Parts find_parts() const
  {
    Parts result;
    std::vector<Index> number(mesh_.number_of_face_slots(), -1);
    result.part.resize(number.size());
    for (Index first = 0; first < Index(number.size()); ++first) {
      if (number[first] >= 0) continue;
      double area = 0, planar_area = 0;
      for (const Index f : component_of(mesh_, first, number)) {
        result.part[f] = Index(result.area.size());
        area += normals_.doubled_areas()[f] / 2;
        if (normals_.is_in_polygon(f)) planar_area += normals_.doubled_areas()[f] / 2;
      }
      result.area.push_back(area);
      result.planar_area.push_back(planar_area);
    }
    return result;
  }

  // The length of these edges in components that are long beside the edges of the mesh, or beside the part that they are on.
  double length_in_long_components(const std::vector<Index>& edges, const Parts& parts) const
  {
    Feature_graph graph(mesh_, own_length_, edges);
    graph.drop_components_shorter_than([&](Index h) {
      return (std::min)(LONG_COMPONENT, LONG_PART * std::sqrt(parts.area[parts.part[h >> 2]]) / own_length_); }, LONG_RING);
    return length_of(graph.edges());
  }

  double length_of(const std::vector<Index>& edges) const
  {
    double sum = 0;
    for (const Index h : edges) sum += std::sqrt(mesh_.squared_edge_length(h));
    return sum;
  }

  // How much of the area is plane, of all and of the part that an edge lies on, in the mean over the length of those that are not flat: the
  // lesser one, as a scene may have edges here, and planes or what has grown there.
  double planar_share(const Parts& parts) const
  {
    const double mild = cosine_of_degrees(MILD_ANGLE);
    double length = 0, beside = 0, area = 0, planar_area = 0;
    for_each_inner_edge(mesh_.number_of_face_slots(), [&](Index h) {
      if (normals_.cosine(h) > mild) return;
      const double l = std::sqrt(mesh_.squared_edge_length(h));
      const Index k = parts.part[h >> 2];
      length += l;
      if (parts.planar_area[k] > 0) beside += l * parts.planar_area[k] / parts.area[k];
    });
    for (std::size_t k = 0; k < parts.area.size(); ++k) {
      area += parts.area[k];
      planar_area += parts.planar_area[k];
    }
    return length > 0 && area > 0 ? (std::min)(beside / length, planar_area / area) : 0.;
  }

  // Free ends, and those where edges meet, among the vertices of these edges.
  void count_vertices(const std::vector<Index>& edges)
  {
    struct Edges { int ridges = 0, grooves = 0; };
    std::vector<Edges> edges_at(mesh_.number_of_vertex_slots());
    std::vector<char> is_at_polygon(edges_at.size());
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f)
      if (normals_.is_in_polygon(f))
        for (Index h = 4 * f; h < 4 * f + 3; ++h) is_at_polygon[mesh_.origin(h)] = true;
    for (const Index h : edges) {
      const bool is_in_groove = normals_.turn(h) < 0;
      for (const Index v : {mesh_.origin(h), mesh_.target(h)}) ++(is_in_groove ? edges_at[v].grooves : edges_at[v].ridges);
    }
    for (Index v = 0; v < Index(edges_at.size()); ++v) {
      const Edges& e = edges_at[v];
      const int degree = e.ridges + e.grooves;
      sharp_vertices_ += degree > 0;
      free_ends_ += degree == 1 && !mesh_.is_border_vertex(v);
      junctions_ += degree > 2;
      const bool is_saddle = e.ridges > 1 && e.grooves > 1;
      saddles_ += is_saddle;
      saddles_off_planes_ += is_saddle && !is_at_polygon[v];
    }
  }

  // Whether many of the vertices of sharp edges are saddles, and none of the planes of a part is beside them.
  bool are_of_noise() const
  {
    return saddles_off_planes_ >= LEAST_SADDLES && double(saddles_off_planes_) > NOISE_SHARE * double(sharp_vertices_);
  }

  // Whether sharp edges are a tangle, over which the surface turns back.
  bool are_of_leaves(const Lengths& lengths) const
  {
    const auto are_more_than = [&](double share, std::size_t n) { return double(n) > share * double(sharp_vertices_); };
    return sharp_vertices_ >= LEAST_TANGLE && are_more_than(LOOSE_SHARE, free_ends_) &&
           are_more_than(TANGLE_SHARE, free_ends_ + junctions_) && turns_back(lengths);
  }

  bool turns_back(const Lengths& lengths) const
  {
    return lengths.turning > (std::max)(TURNING_SHARE, lengths.sharp / lengths.all) * lengths.sharp;
  }

  const Face_normals& normals_;
  const Remeshing_mesh& mesh_;
  double own_length_;
  bool is_cad_ = false, has_uneven_facets_ = false, has_leaves_ = false, has_jagged_chamfers_ = false, has_voxel_stairs_ = false;
  std::size_t sharp_vertices_ = 0, free_ends_ = 0, junctions_ = 0, saddles_ = 0, saddles_off_planes_ = 0;   // of edges of CAD_ANGLE
  std::vector<Index> sharp_edges_, creases_, smooth_curves_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_MODEL_KIND_H
