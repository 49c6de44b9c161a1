// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_CURVATURE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_CURVATURE_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/solve_by_cholesky.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Reference_surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// The largest absolute principal curvature of a triangulated surface, smooth parts and curves apart.
//
// On each face the differences of the normals at its corners give the second fundamental form by least squares (S. Rusinkiewicz,
// Estimating Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004). The forms are averaged over neighborhoods that
// do not reach over features: the sum over a region is what the normals do along its border, so that noise cancels out inside.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A symmetric bilinear form, xx, yy, zz, xy, yz, zx.
struct Bilinear_form
{
  std::array<double, 6> value{};

  Bilinear_form& operator+=(const Bilinear_form& other)
  {
    for (std::size_t i = 0; i < value.size(); ++i) value[i] += other.value[i];
    return *this;
  }
  friend Bilinear_form operator*(double factor, Bilinear_form form)
  {
    for (double& x : form.value) x *= factor;
    return form;
  }
  // The form u vᵀ + v uᵀ, by half.
  static Bilinear_form product(const Vector3& u, const Vector3& v)
  {
    return {{u.x * v.x, u.y * v.y, u.z * v.z,
             (u.x * v.y + u.y * v.x) / 2, (u.y * v.z + u.z * v.y) / 2, (u.z * v.x + u.x * v.z) / 2}};
  }
};

// The largest absolute eigenvalue, by the trigonometric solution of the characteristic equation.
inline double spectral_radius(const Bilinear_form& form)
{
  const auto& m = form.value;
  const double mean = (m[0] + m[1] + m[2]) / 3, a = m[0] - mean, b = m[1] - mean, c = m[2] - mean;
  const double p = std::sqrt((a * a + b * b + c * c + 2 * (m[3] * m[3] + m[4] * m[4] + m[5] * m[5])) / 6);
  if (!(p > 0)) return std::abs(mean);
  const double determinant = a * (b * c - m[4] * m[4]) - m[3] * (m[3] * c - m[4] * m[5]) + m[5] * (m[3] * m[4] - b * m[5]);
  const double angle = std::acos((std::max)(-1., (std::min)(1., determinant / (2 * p * p * p)))) / 3;
  return (std::max)(std::abs(mean + 2 * p * std::cos(angle)), std::abs(mean + 2 * p * std::cos(angle + 2 * CGAL_PI / 3)));
}

class Curvature
{
  using Index = Reference_surface::Index;

public:
  // Of a mesh without free slots, its features marked, and the edges on its rim, which are no curves unless they are features.
  explicit Curvature(const Remeshing_mesh& mesh)
    : mesh_(mesh), surface_(mesh), mls_(surface_, std::vector<Index>(), -1, nullptr, false)
  {
    const std::size_t n = surface_.number_of_faces();
    forms_.resize(n);
    area_.resize(n);
    for (Index f = 0; f < Index(n); ++f) {
      area_[f] = length(surface_.cross_product(f)) / 2;
      forms_[f] = form_of_face(f);
    }
  }

  Curvature(const Curvature&) = delete;      // `mls_` refers to `surface_`
  Curvature& operator=(const Curvature&) = delete;

  // Averages over neighborhoods of the radius `radius_at(largest absolute curvature)`, of two edges at least and six at most.
  template <class Radius>
  void average(const Radius& radius_at);

  // At each vertex: of the most curved one of the smooth parts that meet there, and of the border and feature curves.
  std::vector<double> at_vertices() const;

private:
  // A round of averages over a face and those beside it adds about this many squared edge lengths to the square of the radius.
  static constexpr double SPREAD = 0.5;
  static constexpr int LEAST_ROUNDS = 8, MOST_ROUNDS = 64, CURVE_ROUNDS = 4;

  Bilinear_form form_of_face(Index f) const;
  void add_curves(std::vector<double>& result) const;

  const Remeshing_mesh& mesh_;
  Reference_surface surface_;
  Mls_surface mls_;
  std::vector<Bilinear_form> forms_;     // by face
  std::vector<double> area_;
};

inline Bilinear_form Curvature::form_of_face(Index f) const
{
  const auto& corner = surface_.face_record(f).vertex;
  const Vector3 cross_product = surface_.cross_product(f);
  const double l = mls_.size(f), doubled_area = length(cross_product);
  if (!(doubled_area > 0)) return {};
  std::array<Vector3, 3> normal;
  for (int k = 0; k < 3; ++k) {
    if (mls_.sector(f, k) < 0) return {};
    normal[k] = mls_.sector_normal(mls_.sector(f, k));
  }
  Vector3 u, v;
  complete_frame((1 / doubled_area) * cross_product, u, v);
  std::array<std::array<double, 3>, 3> a{};
  std::array<double, 3> b{};
  for (int k = 0; k < 3; ++k) {
    const Vector3 e = (1 / l) * (surface_.position(corner[(k + 1) % 3]) - surface_.position(corner[k])),
                  change = normal[(k + 1) % 3] - normal[k];
    const double x = dot(e, u), y = dot(e, v), in_u = dot(change, u), in_v = dot(change, v);
    a[0][0] += x * x;
    a[1][0] += x * y;
    a[1][1] += x * x + y * y;
    a[2][1] += x * y;
    a[2][2] += y * y;
    b[0] += x * in_u;
    b[1] += y * in_u + x * in_v;
    b[2] += y * in_v;
  }
  if (!solve_by_cholesky(a, b)) return {};
  Bilinear_form result = (b[0] / l) * Bilinear_form::product(u, u);
  result += (2 * b[1] / l) * Bilinear_form::product(u, v);
  result += (b[2] / l) * Bilinear_form::product(v, v);
  return result;
}

template <class Radius>
void Curvature::average(const Radius& radius_at)
{
  std::vector<Index> active(surface_.number_of_faces());
  for (std::size_t f = 0; f < active.size(); ++f) active[f] = Index(f);
  std::vector<Bilinear_form> averaged(forms_);
  for (int round = 0; round < MOST_ROUNDS && !active.empty(); ++round) {
    for (const Index f : active) {
      Bilinear_form sum = area_[f] * forms_[f];
      double total = area_[f];
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        if (mls_.is_feature(h) || surface_.is_border(h)) continue;
        const Index g = surface_.face(surface_.opposite(h));
        sum += area_[g] * forms_[g];
        total += area_[g];
      }
      if (total > 0) averaged[f] = (1 / total) * sum;
    }
    for (const Index f : active) forms_[f] = averaged[f];
    if (round + 1 < LEAST_ROUNDS) continue;
    active.erase(std::remove_if(active.begin(), active.end(), [&](Index f) {
      return mls_.size(f) * std::sqrt(SPREAD * (round + 1)) >= radius_at(spectral_radius(forms_[f]));
    }), active.end());
  }
}

inline std::vector<double> Curvature::at_vertices() const
{
  struct Sum { Bilinear_form form; double area = 0; };
  std::vector<Sum> sectors(mls_.number_of_sectors());
  const auto for_each_corner = [&](const auto& function) {
    for (Index f = 0; f < Index(surface_.number_of_faces()); ++f)
      for (int k = 0; k < 3; ++k)
        if (mls_.sector(f, k) >= 0) function(f, surface_.face_record(f).vertex[k], sectors[mls_.sector(f, k)]);
  };
  for_each_corner([&](Index f, Index, Sum& sector) {
    sector.form += area_[f] * forms_[f];
    sector.area += area_[f];
  });
  for (Sum& s : sectors)
    if (s.area > 0) s.form = (1 / s.area) * s.form;
  std::vector<double> result(surface_.number_of_vertices(), 0);
  for_each_corner([&](Index, Index v, const Sum& sector) { result[v] = (std::max)(result[v], spectral_radius(sector.form)); });
  add_curves(result);
  return result;
}

// The curvature vector of a polyline at a vertex is what its direction changes by, over the length that this vertex stands for.
inline void Curvature::add_curves(std::vector<double>& result) const
{
  struct Vertex { std::array<Index, 2> neighbor{-1, -1}; int degree = 0; Vector3 curvature; bool is_smooth = false; };
  std::vector<Vertex> vertices(surface_.number_of_vertices());
  const auto join = [&](Index v, Index u) {
    Vertex& vertex = vertices[v];
    if (vertex.degree < 2) vertex.neighbor[vertex.degree] = u;
    ++vertex.degree;
  };
  std::vector<Index> on_curves;
  for (Index h = 0; h < 4 * Index(surface_.number_of_faces()); ++h) {
    const bool is_curve = mls_.is_feature(h) && (!mesh_.is_on_rim(h) || mesh_.is_constrained(h));
    if (surface_.corner(h) == 3 || !is_curve || surface_.opposite(h) > h) continue;
    join(surface_.origin(h), surface_.target(h));
    join(surface_.target(h), surface_.origin(h));
  }
  for (Index v = 0; v < Index(vertices.size()); ++v) {
    Vertex& vertex = vertices[v];
    if (vertex.degree != 2) continue;
    const Vector3 in = surface_.position(v) - surface_.position(vertex.neighbor[0]),
                  out = surface_.position(vertex.neighbor[1]) - surface_.position(v);
    const double before = length(in), after = length(out);
    if (!is_cosine_at_least(in, out, CORNER_COSINE)) continue;
    vertex.curvature = (2 / (before + after)) * ((1 / after) * out - (1 / before) * in);
    vertex.is_smooth = true;
    on_curves.push_back(v);
  }
  std::vector<Vector3> averaged(on_curves.size());
  for (int round = 0; round < CURVE_ROUNDS; ++round) {
    for (std::size_t i = 0; i < on_curves.size(); ++i) {
      const Vertex& vertex = vertices[on_curves[i]];
      Vector3 sum = 2 * vertex.curvature;
      for (const Index u : vertex.neighbor) sum += vertices[u].is_smooth ? vertices[u].curvature : vertex.curvature;
      averaged[i] = 0.25 * sum;
    }
    for (std::size_t i = 0; i < on_curves.size(); ++i) vertices[on_curves[i]].curvature = averaged[i];
  }
  for (const Index v : on_curves) result[v] = (std::max)(result[v], length(vertices[v].curvature));
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_CURVATURE_H
