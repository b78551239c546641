// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace ringmotor
{
  struct CondensedMotor;
  struct Parameters;

  /** The distance of the faces in contact at rest, before the bodies are pressed together, at the
   * nodes of a tooth; the same for all teeth. A warp of the ring comes in addition. */
  struct RestGap
  {
    std::vector<double> drawn;      ///< m, by the shape of the faces; empty: level
    std::vector<double> deflection; ///< m/N, by which the faces part where a preload that is spread
                                    ///< evenly presses them; its mean is zero
    bool is_lapped = false; ///< the faces are worn until they are parallel under their preload

    /** m, at a node under a @p preload (N); up to a constant, which the rise of the rotor takes. */
    double at(const unsigned int node, const double preload) const
    {
      return is_lapped ? -preload * deflection[node] : drawn.empty() ? 0. : drawn[node];
    }
    /** How far the faces are from parallel if a preload (N) presses them evenly: the difference of
     * the largest and the smallest distance, m. */
    double unevenness(const double preload) const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &drawn &deflection &is_lapped;
    }
  };

  /** That of a motor whose bodies are condensed: the drawn shapes, and the deflection by the static
   * compliance and by the modes without nodal diameters. */
  RestGap rest_gap(const Parameters &parameters, const CondensedMotor &motor);

  /** The same on coarse meshes, by the compliance of rotor and teeth alone: before anything else of
   * a motor is known. */
  RestGap rough_rest_gap(Parameters parameters);

  /** How far the faces are from parallel under the preload, in words; it is a warning if that is
   * more than the amplitude of the wave. */
  std::string describe_faces(const RestGap &gap, const Parameters &parameters);
} // namespace ringmotor
