// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_FACE_COUNT_H
#define CGAL_INTER_ANGLE_REMESHING_FACE_COUNT_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Inter_angle_remeshing {

template <class SizingField>
struct Scaled_sizing_field;

namespace internal {

template <class Number>
std::size_t checked_face_count(Number n)
{
  constexpr double TOO_MANY = 9e18;                  // for std::size_t, with room for rounding
  if (!(double(n) >= 0)) refuse("Face_count", "the wanted number of faces is " + to_text(double(n)));
  if (double(n) >= TOO_MANY) refuse("Face_count", "the wanted number of faces is " + to_text(double(n)) + ", which cannot be indexed");
  return std::size_t(n);
}

} // namespace internal

/*!
\ingroup PkgInterAngleRemeshingRef

@brief a wanted number of faces, in place of a target edge length.

A run begins with the length of `target_edge_length()` and, where the number of faces falls or stays, corrects it from
iteration to iteration; in the last two it collapses the shortest edges or splits the longest ones until the number is met, as
far as geometry and policies allow, but each time changes it by a tenth at most. Where `Recipe::grading` adds faces at details of curves, as on
CAD models, the length stays as it is during the iterations, and up to four times these begin anew with a better one, until the number is
within 4%; this takes one to three times as long. Where the clean-up then leaves more than a hundredth
too many or too few, that is corrected, and faces are mended again, up to eight times. Measured on 30 organic models from .02 to 3
times their number of faces: within 1.1%, .1% in the mean, wherever the result has 500 faces and more (185 runs); with 100 to 500
(43 runs) within 2% in 40, within 11% in all; with fewer, thin parts may not be made of so few (elephant has 86 for 100). Holes are kept, and
cost faces: elephant-with-holes, with 106 of them, has 1199 for 1000 and 1558 for 1500. On CAD models features and corners
that cost more faces than are wanted are kept all the same. Of six (fandisk, rotor, joint, couplingdown, spool, pinion) all
meet 1, 3 and 10 times their number of faces within 1.5%; .3 of it four meet within 2%, pinion within 5% and joint within 21%. With `Recipe::paper()`, whose policies
forbid more than lengths ask for, it is 1 to 2 times as many on most, up to 8 times where the parts have long facets.
*/
struct Face_count
{
  /// @tparam Number an arithmetic type, or what is convertible to one
  /// @param n the wanted number of faces; a fraction is dropped
  /// @throws CGAL::Precondition_exception if `n` is negative, or so large that it cannot be indexed
  template <class Number, class = std::enable_if_t<std::is_convertible<Number, double>::value>>
  explicit Face_count(Number n) : value(internal::checked_face_count(n)) {}

  /// the same number of faces, sized by a field: its lengths are multiplied by the one factor that yields so many.
  /// @param field what `isotropic_remeshing()` takes in place of a length: a class with the member `at()` of `PMPSizingField` or a
  ///        function of the position; it is copied, hand it over by `std::ref` if that is dear
  template <class SizingField>
  Scaled_sizing_field<SizingField> scaling(const SizingField& field) const;

  /// the wanted number of faces
  std::size_t value;
};

/*!
\ingroup PkgInterAngleRemeshingRef

@brief a sizing field whose lengths are scaled such that a wanted number of faces results; made by `Face_count::scaling()`.
*/
template <class SizingField>
struct Scaled_sizing_field
{
  /// the wanted number of faces
  Face_count count;
  /// the field
  SizingField field;
};

template <class SizingField>
Scaled_sizing_field<SizingField> Face_count::scaling(const SizingField& field) const { return {*this, field}; }

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_FACE_COUNT_H
