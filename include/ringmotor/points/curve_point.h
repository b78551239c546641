// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/marching.h>
#include <ringmotor/points/contact_fields.h>
#include <ringmotor/points/operating_point.h>
#include <ringmotor/points/point_error.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace ringmotor
{
  /** A requested operating point. */
  struct PointRequest
  {
    Control control;
    double value; ///< N m or rad/s

    bool operator==(const PointRequest &other) const
    {
      return control == other.control && value == other.value;
    }
    bool operator<(const PointRequest &other) const
    {
      return std::tie(control, value) < std::tie(other.control, other.value);
    }

    /** All of it, to distinguish requests: `torque 0.05`. */
    std::string text() const;
  };

  /** The points that Loading/Values lists; none for a curve, see points_along_curve(). */
  std::vector<PointRequest> listed_points(const Loading &loading);

  /** The load on the rotor at a requested operating point. */
  RotorLoad load_of(const Loading &loading, const PointRequest &request);

  /** Causes of errors that are named in several places; see ErrorCause for all. */
  namespace causes
  {
    inline constexpr const char *meshes    = "meshes of bodies and interface",
                                *time_step = "time step",
                                *wave      = "wave of the stator"; ///< as `stator` estimates it
  }                                                                // namespace causes

  /** An operating point and the effort to find it. */
  struct CurvePoint
  {
    PointRequest request{};
    OperatingPoint result;
    std::vector<double> rotor_energies; ///< J, see rotor_energies()
    double rotor_power = 0.;            ///< W, see power_per_loss_factor()
    PointError unsettled_means; ///< of a marched motor: how far they may be from their limits
    std::map<std::string, PointError> errors; ///< by cause
    double largest_violation = 0.; ///< of the laws of contact and friction, see ContactCertificate
    /** What the search for the amplitude and the frequency of the wave leaves open, see StableRoot:
     * where the state jumps with them, the whole jump. */
    PointError unsettled;
    unsigned int n_iterations = 0;
    double seconds            = 0.;
    double largest_share      = 0.; ///< see ContactFields::largest_share()
    std::string remark;             ///< how it was found, if not by Newton's method alone
    MarchedState end;               ///< of a marched motor, after its last step
    ContactFields fields; ///< without values where nothing needs them any more, see PointTable

    /** Of all causes, which are independent. */
    PointError error() const;

    /** Adds what the solver reports of a state. */
    void add_certificate(const ContactSolution &solution);

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &request.control &request.value &result &unsettled_means &errors;
      archive &rotor_energies &rotor_power &largest_violation &unsettled &n_iterations &seconds
          &largest_share &remark &end &fields;
    }
  };
} // namespace ringmotor
