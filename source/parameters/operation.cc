// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/operation.h>

namespace ringmotor
{
  using namespace dealii;

  void Loading::declare(ParameterHandler &prm)
  {
    add_entry(prm, "Preload", preload, plausible(positive_number(), 1e-3, 1e5),
              "Total axial force that presses the rotor ring down on its top face. Units: N.",
              Presence::required);
    add_entry(prm, "Control", control,
              selection<Control>({{"torque", Control::torque}, {"speed", Control::speed}}),
              "The quantity that is prescribed; the other one is computed.");
    add_entry(prm, "Values", values, numbers_or("curve", any_number()),
              "The prescribed torques or speeds; \"curve\" covers no load to stall. Units: N m for "
              "torque and rad/s for speed.");
    add_entry(
        prm, "Number of curve points", n_curve_points, whole_number(2, 1000),
        "Number of operating points of a curve; they are equidistant along it from no load to "
        "stall.");
  }

  FrictionLaw::FrictionLaw(const std::string &name) : number(0)
  {
    const std::vector<FrictionLawEntry> &entries = friction_law_entries();
    while (number < entries.size() && entries[number].name != name)
      ++number;
    AssertThrow(number < entries.size(), ExcMessage(name + " is no law of friction"));
  }

  void Friction::declare(ParameterHandler &prm)
  {
    std::vector<std::pair<std::string, FrictionLaw>> laws;
    std::string described = "Friction law: ";
    for (const FrictionLawEntry &entry : friction_law_entries())
    {
      described += (laws.empty()                                      ? ""
                    : laws.size() + 1 < friction_law_entries().size() ? ", "
                                                                      : ", or ") +
                   entry.description;
      laws.emplace_back(entry.name, FrictionLaw(entry.name));
    }
    add_entry(prm, "Law", law, selection<FrictionLaw>(laws), described + ".");
    add_entry(prm, "Static coefficient", static_coefficient,
              plausible(non_negative_number(), 1e-3, 5.),
              "Coefficient of friction of sticking contact nodes; with the law \"coulomb\" it is "
              "not used. Units: none.",
              Presence::required);
    add_entry(
        prm, "Dynamic coefficient", dynamic_coefficient, plausible(non_negative_number(), 1e-3, 5.),
        "Coefficient of friction of slipping contact nodes. Units: none.", Presence::required);
    add_entry(prm, "Decay velocity", decay_velocity,
              number_or("none", plausible(positive_number(), 1e-6, 1e3)),
              "Sliding velocity over which the law \"velocity\" decays. Units: m/s.");
    add_entry(prm, "Weakening length", weakening_length,
              number_or("none", plausible(positive_number(), 1e-10, 1e-2)),
              "Sliding length over which the law \"slip-weakening\" decays. Units: m.");
    add_entry(prm, "Lining normal stiffness", lining_normal_stiffness,
              number_or("none", plausible(positive_number(), 1e6, 1e18)),
              "Normal stiffness per area of a friction lining. Units: N/m^3.");
    add_entry(prm, "Lining tangential stiffness", lining_tangential_stiffness,
              number_or("none", plausible(positive_number(), 1e6, 1e18)),
              "Tangential stiffness per area of a friction lining. Units: N/m^3.");
  }

  void InitialDeformation::declare(ParameterHandler &prm)
  {
    add_entry(
        prm, "Amplitude", amplitude, plausible(non_negative_number(), 1e-10, 1e-3),
        "Amplitude A of the warp A cos(m theta) of the tooth tops at rest, an axial displacement; "
        "theta is measured from the centre of tooth 0. Units: m.");
    add_entry(prm, "Number of waves", n_waves, whole_number(0, 5000),
              "Number of waves m of the warp around the ring.");
  }

  void Support::check() const
  {
    const bool is_whole = felt_thickness && felt_modulus && felt_loss_factor,
               is_empty = !felt_thickness && !felt_modulus && !felt_loss_factor;
    if (!is_whole && !is_empty)
      throw UserError(
          "Support/Felt thickness, Felt modulus and Felt loss factor are not all given; "
          "allowed: all three, or none of them for a motor without felt");
  }

  void Support::declare(ParameterHandler &prm)
  {
    add_entry(prm, "Felt thickness", felt_thickness, number_or("none", thickness()),
              "Thickness of the felt ring under the stator; \"none\" for a motor without felt. "
              "Units: m.");
    add_entry(prm, "Felt modulus", felt_modulus,
              number_or("none", plausible(positive_number(), 1e2, 1e11)),
              "Modulus of elasticity of the felt in compression. Units: Pa.");
    add_entry(prm, "Felt loss factor", felt_loss_factor,
              number_or("none", number_within(0., 10., "a number from 0 to 10")),
              "Energy lost per radian of vibration over the largest stored energy. Units: none.");
    add_entry(prm, "Felt inner radius", felt_inner_radius, number_or("base", radius()),
              "Inner radius of the felt ring; \"base\" takes that of the stator's base. Units: m.");
    add_entry(prm, "Felt outer radius", felt_outer_radius, number_or("base", radius()),
              "Outer radius of the felt ring, \"base\" as before. Units: m.");
  }

  void Contact::declare(ParameterHandler &prm)
  {
    add_entry(prm, "Formulation", formulation,
              selection<ContactFormulation>({{"mortar", ContactFormulation::mortar},
                                             {"penalty", ContactFormulation::penalty}}),
              "How contact is enforced: by mortar integrals, or by springs at the nodes as in the "
              "paper.");
    add_entry(
        prm, "Faces", faces,
        selection<ContactFaces>({{"drawn", ContactFaces::drawn}, {"lapped", ContactFaces::lapped}}),
        "The faces in contact at rest: as drawn in the sections (level without one), or "
        "lapped, which is worn until they are parallel under the preload, spread evenly; a "
        "rotor whose thin parts turn under the preload touches with an edge otherwise.");
    add_entry(prm, "Normal penalty", normal_penalty,
              number_or("none", plausible(positive_number(), 1e2, 1e15)),
              "Stiffness of the normal springs of the formulation \"penalty\". Units: N/m.");
    add_entry(prm, "Tangential penalty", tangential_penalty,
              number_or("none", plausible(positive_number(), 1e2, 1e15)),
              "Stiffness of the tangential springs of the formulation \"penalty\". Units: N/m.");
  }

  void Time::declare(ParameterHandler &prm)
  {
    constexpr unsigned int most_steps = 1000000;
    add_entry(
        prm, "Scheme", scheme,
        selection<TimeScheme>({{"auto", TimeScheme::automatic},
                               {"steady", TimeScheme::steady},
                               {"marching", TimeScheme::marching}}),
        "How the period is computed: directly as a steady state, or by time steps from a rotor "
        "pressed without friction on the teeth; \"auto\" selects the steady state for a "
        "uniform ring.");
    add_entry(prm, "Time step", time_step, plausible(positive_number(), 1e-11, 1e-3),
              "Step of the scheme \"marching\", shortened if a period of the solution has to be "
              "a whole number of steps. Units: s.");
    add_entry(prm, "Number of steps", n_steps, number_or("auto", whole_number(1, most_steps)),
              "Number of steps of the scheme \"marching\"; \"auto\" continues until the means over "
              "whole periods of the solution are known to a part of Accuracy/Contact target.");
    add_entry(prm, "Average from step", average_from_step,
              number_or("auto", whole_number(1, most_steps)),
              "First step, counted from 1, over which results are averaged; \"auto\" averages over "
              "the last whole period of the solution, or over many if they differ.");
    add_entry(prm, "Average to step", average_to_step,
              number_or("auto", whole_number(1, most_steps)),
              "Last step over which results are averaged, \"auto\" as before.");
    add_entry(
        prm, "Snapshots", n_snapshots, whole_number(1, 1000),
        "Number of interleaved time samples of the scheme \"steady\", and of substeps of each "
        "step of the scheme \"marching\"; a larger number gives a smaller time step.");
    add_entry(
        prm, "Spectral radius", spectral_radius, number_within(0., 0.99, "a number from 0 to 0.99"),
        "Dissipation of the time integration of a rotor with inertia: factor by which each step "
        "multiplies the amplitude of motions much faster than the step.");
  }
} // namespace ringmotor
