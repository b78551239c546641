// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/condensed_motor.h>
#include <ringmotor/motor/contact_bodies.h>

#include <array>
#include <complex>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace ringmotor
{
  /** A single tooth: its compliance, and the motion of its top due to that of its foot. */
  struct CondensedTooth
  {
    SectorSurface surface;
    dealii::FullMatrix<double> compliance;
    std::vector<std::array<std::complex<double>, 3>> free_motion; ///< by node of the surface
    unsigned int n_dofs;
  };

  /** The rotor, condensed to its contact with one tooth. */
  struct CondensedRotor
  {
    MortarCoupling mortar;
    RingCompliance compliance;
    std::vector<CondensedMotor::NearRigidMode> near_rigid_modes;
    double mass; ///< kg, as CondensedMotor::rotor_mass
    unsigned int n_dofs;
  };

  /** Both bodies of a motor without their inertia under contact forces, condensed to their contact.
   */
  struct CondensedBodies
  {
    CondensedTooth tooth;
    CondensedRotor rotor;
  };

  /** @throws UserError if the lip misses the teeth */
  CondensedBodies condense_bodies(const Parameters &parameters, const StatorWave &wave,
                                  const ContactDiscretisation &discretisation);

  /** The condensed bodies of one motor: those on the coarsest mesh are kept, because motors with
   * and without each effect that is measured have them in common. An effect that changes what
   * condense_bodies() makes belongs in the key of #coarsest. */
  class BodiesByMesh
  {
  public:
    /** See condense_bodies(). @param parameters of this motor, with any effects of the contact;
     * @param wave the same in all calls */
    std::shared_ptr<const CondensedBodies> at(const Parameters &parameters, const StatorWave &wave,
                                              const ContactDiscretisation &discretisation) const;

  private:
    /** On the coarsest mesh, by MotorModel::teeth_move_with_inertia, rotor_gives_way_along and
     * rotor_moves_as_whole. */
    mutable std::map<std::tuple<bool, bool, bool>, std::shared_ptr<const CondensedBodies>> coarsest;
  };

  /** The largest relative change of the tangential motion of the tooth tops due to the inertia of
   * the teeth. */
  double tooth_inertia_indicator(const Parameters &parameters, const StatorWave &wave);
} // namespace ringmotor
