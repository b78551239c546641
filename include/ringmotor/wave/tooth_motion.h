// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/modes.h>

#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace ringmotor
{
  /** A named point of the tooth and its place in the mesh. */
  struct ToothPoint
  {
    std::string name; ///< e.g. top_outer_C: top or foot; inner, mid, outer radius; L, C, R = -theta
                      ///< edge, centre, +theta edge
    dealii::Point<3> position;
    dealii::DoFHandler<3>::active_cell_iterator cell;
    dealii::Point<3> unit; ///< of the mirror image where `mirrored`
    bool mirrored = false; ///< on the half that is not meshed: U(-theta) = S conj(U(theta))
  };

  /**
   * The elliptic motion of a point in the conventions of eq. (2) of the paper. With theta its
   * angle: normal w_n = A_n cos(omega t - n theta - phase_n) along +z; tangential w_t = A_t
   * sin(omega t - n theta - phase_n - phi) along the driven direction -theta, so that phi alone
   * tilts the ellipse; radial w_r = A_r cos(omega t - n theta - phase_r). Amplitudes zero to peak
   * in m, phases in rad, in (-pi, pi].
   */
  struct EllipticMotion
  {
    double normal, tangential, radial; ///< A_n, A_t, A_r
    double phase_n, phi, phase_r;

    /** A_r with the sign of the radial motion at the crest: negative inwards, m. */
    double radial_along_normal() const { return radial * std::cos(phase_r - phase_n); }
  };

  /**
   * The 18 points where the tooth's motion is reported: inner, middle and outer radius times two
   * edges and centre, of the tooth's top and of its foot. None without teeth.
   */
  std::vector<ToothPoint> tooth_points(const CyclicSector &sector);

  /** Cartesian complex displacement amplitude at a point of the tooth. */
  std::array<std::complex<double>, 3> displacement_at(const ToothPoint &point,
                                                      const ComplexField &field);

  /** The ellipse on which @p point moves in @p mode. */
  EllipticMotion elliptic_motion(const ToothPoint &point, const Mode &mode);

  /**
   * Scales @p mode so that the normal amplitude at the outer edge of the tooth top (top_outer_C) is
   * @p amplitude in m, and shifts its phase so that the crest is there at t = 0.
   */
  void normalise_to_amplitude(Mode &mode, const std::vector<ToothPoint> &points,
                              const double amplitude);
} // namespace ringmotor
