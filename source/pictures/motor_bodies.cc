// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/pictures/motor_bodies.h>
#include <ringmotor/structure/mirror.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /**
     * Forces F on the nodes of a sector's surface are F_1 + i F_2, both with the symmetry
     * F(-theta) = S conj(F(theta)) of a half sector's real and imaginary fields: the two loads on
     * the half sector. (A node on the mirror plane counts half.)
     */
    std::vector<CondensationLoad> loads_on_half(const std::vector<std::array<Complex, 3>> &forces,
                                                const SectorSurface &surface)
    {
      unsigned int n_half = 0;
      for (const MirroredNode &node : surface.origin)
        n_half = std::max(n_half, node.node + 1);
      const std::size_t n_forms = 3 * n_half;
      std::vector<CondensationLoad> loads(2, {std::vector<double>(2 * n_forms, 0.), {}, {}});
      for (unsigned int a = 0; a < forces.size(); ++a)
      {
        const auto [node, is_mirrored]     = surface.origin[a];
        const std::array<Complex, 3> force = is_mirrored ? mirrored(forces[a]) : forces[a];
        for (unsigned int c = 0; c < 3; ++c)
        {
          const Complex first  = 0.5 * force[c],
                        second = (is_mirrored ? -1. : 1.) * 0.5 * force[c] / Complex(0., 1.);
          loads[0].forces[3 * node + c] += first.real();
          loads[0].forces[n_forms + 3 * node + c] += first.imag();
          loads[1].forces[3 * node + c] += second.real();
          loads[1].forces[n_forms + 3 * node + c] += second.imag();
        }
      }
      return loads;
    }

    /** The largest component of forces on nodes. */
    double largest_of(const std::vector<std::array<Complex, 3>> &forces)
    {
      double largest = 0.;
      for (const std::array<Complex, 3> &force : forces)
        for (const Complex &component : force)
          largest = std::max(largest, std::abs(component));
      return largest;
    }

    /** The mean axial motion of all contact points by modes at a time sample (m): of waves around
     * the ring it vanishes. */
    double mean_modal_rise(const PointSample &at)
    {
      const ContactFields &fields = at.fields;
      const std::size_t n_samples = fields.times.size(), n = fields.modal.size() / n_samples;
      double sum = 0.;
      for (std::size_t i = at.sample * n; i < (at.sample + 1) * n; ++i)
        sum += fields.modal[i][0];
      return sum / n;
    }
    void add_those_of_other_ranks(RingBody::Displacement &displacement, const MPI_Comm ranks)
    {
      if (Utilities::MPI::n_mpi_processes(ranks) == 1 || displacement.empty())
        return;
      const ArrayView<double> numbers(displacement.front().begin_raw(), 3 * displacement.size());
      Utilities::MPI::sum(ArrayView<const double>(numbers), ranks, numbers);
    }
  } // namespace

  MotorBodies::MotorBodies(const Parameters &parameters, const StatorWave &wave,
                           const ContactDiscretisation &discretisation,
                           const unsigned int n_subdivisions, const MPI_Comm ranks)
      : parameters(parameters), model(motor_model(parameters)), wave(wave),
        lip_turn(discretisation.lip_turn), tooth_body(parameters, discretisation),
        rotor_body(parameters, discretisation),
        mortar(couple(tooth_body.whole_top.surface, rotor_body.whole_lip.surface,
                      2. * numbers::PI / parameters.motor.n_teeth, discretisation.lip_turn)),
        rotor_ring(rotor_body.sector, n_subdivisions,
                   rise_to_contact(*rotor_shape(parameters), *stator_shape(parameters)),
                   discretisation.lip_turn),
        tooth_ring(tooth_body.sector, n_subdivisions), ranks(ranks)
  {
  }

  std::vector<MotorBodies::Amplitudes> MotorBodies::lip_forces(const PointSample &at) const
  {
    const unsigned int n_teeth = parameters.motor.n_teeth, n_nodes = mortar.nodes.size(),
                       n_lip = rotor_body.whole_lip.origin.size(), n_waves = n_teeth / 2 + 1;
    const bool has_friction = model.rotor_gives_way_along;
    std::vector<Amplitudes> amplitudes(n_waves, Amplitudes(n_lip));
    for (unsigned int tooth = 0; tooth < n_teeth; ++tooth)
      for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const PointVector &force = at.fields.state.force[at.fields.point(at.sample, tooth, a)];
        if (force == PointVector())
          continue;
        for (const MortarCoupling::Weight &weight : mortar.nodes[a].weights)
          for (unsigned int k = 0; k < n_waves; ++k)
          {
            // Waves k and N - k are conjugate to each other; here one stands for both.
            const double share = (k == 0 || 2 * k == n_teeth ? 1. : 2.) / n_teeth;
            const auto sector  = static_cast<double>(tooth) + weight.sector;
            const Complex factor =
                weight.weight * share * std::polar(1., 2. * numbers::PI * k * sector / n_teeth);
            for (unsigned int c = 0; c < (has_friction ? 3 : 1); ++c)
              amplitudes[k][weight.rotor_node][c] += factor * force[c];
          }
      }
    return amplitudes;
  }

  void MotorBodies::add_static_motion(const std::vector<PointSample> &samples,
                                      std::vector<RingBody::Displacement> &displacements) const
  {
    const unsigned int n_teeth      = parameters.motor.n_teeth;
    const Condensation condensation = rotor_body.condensed(true);
    std::vector<std::vector<Amplitudes>> forces;
    std::vector<double> largest(n_teeth / 2 + 1, 0.); // by nodal diameter
    for (const PointSample &at : samples)
    {
      forces.push_back(lip_forces(at));
      for (unsigned int k = 0; k < largest.size(); ++k)
        largest[k] = std::max(largest[k], largest_of(forces.back()[k]));
    }
    const double rounding = 1e-12 * *std::max_element(largest.begin(), largest.end());

    TaskQueue diameters(largest.size(), ranks);
    for (std::size_t k; diameters.take(k);)
    {
      if (k > 1 && largest[k] <= rounding) // as most where the forces repeat around the ring
        continue;
      const std::vector<unsigned int> held = rotor_body.held(k);
      std::vector<CondensationLoad> loads;
      for (unsigned int m = 0; m < samples.size(); ++m)
      {
        std::vector<CondensationLoad> of_sample = loads_on_half(forces[m][k], rotor_body.whole_lip);
        // Displacements of supports, see RingContact: rise, then cosine and sine parts of each
        // near-rigid mode. The rotation is left out.
        const std::vector<double> &rigid = samples[m].fields.state.rigid;
        AssertThrow(!rigid.empty(), ExcMessage("the rigid motions of the rotor are missing"));
        const std::size_t n_rigid = rigid.size() / samples[m].fields.times.size(),
                          first   = samples[m].sample * n_rigid;
        for (unsigned int part = 0; part < 2; ++part)
        {
          std::vector<double> &supports = of_sample[part].supports;
          supports.assign(held.size(), 0.);
          if (k == 0 && part == 0)
            supports[0] = rigid[first];
          else if (k == 1 && n_rigid > 1)
            for (unsigned int i = 0; i < held.size(); ++i)
              supports[i] = rigid[first + 1 + 2 * i + part];
          loads.push_back(std::move(of_sample[part]));
        }
      }
      const std::vector<SectorMotion> motions = condensation.interior(k, held, loads);
      for (unsigned int m = 0; m < samples.size(); ++m)
      {
        const RingBody::Amplitude amplitude =
            rotor_ring.amplitude(motions[2 * m], motions[2 * m + 1]);
        for (unsigned int sector = 0; sector < n_teeth; ++sector)
          rotor_ring.add(sector, std::polar(1., -2. * numbers::PI * k * sector / n_teeth),
                         amplitude, displacements[m]);
      }
    }
    diameters.finish();
  }

  std::vector<RingBody::Displacement>
  MotorBodies::rotor_motions(const CondensedMotor &motor, const RotorVibration &vibration,
                             const std::vector<PointSample> &samples) const
  {
    std::vector<RingBody::Displacement> displacements(samples.size(), rotor_ring.at_rest());
    add_static_motion(samples, displacements);
    if (motor.has_modes_of(ModePart::rotor))
      add_vibration(motor, vibration, samples, displacements);
    for (RingBody::Displacement &displacement : displacements)
      add_those_of_other_ranks(displacement, ranks);
    // The stator is drawn in its wave alone. What else it does under contact forces is mostly to
    // sink under the preload: relative to it, the rotor rises.
    if (motor.has_modes_of(ModePart::stator))
      for (std::size_t m = 0; m < samples.size(); ++m)
      {
        const double rise = mean_modal_rise(samples[m]);
        for (auto &displacement : displacements[m])
          displacement[2] += rise;
      }
    return displacements;
  }

  std::vector<RingBody::Displacement>
  MotorBodies::teeth_motions(const std::vector<PointSample> &samples) const
  {
    const unsigned int n_teeth = parameters.motor.n_teeth, n_nodes = mortar.nodes.size();
    const Condensation condensation = tooth_body.condensed(0., true);
    const Warp &warp                = model.warp;
    const SectorMotion at_rest      = tooth_body.sector.at_rest();
    const auto following            = [&](const Condensation &tooth) {
      return tooth.interior(0, {}, {{{}, tooth_body.foot_motion(wave.foot), {}}}).front();
    };
    // Contact forces move a tooth nearly as if it had no inertia.
    const RingBody::Amplitude free_motion =
        tooth_ring.amplitude(model.teeth_move_with_inertia
                                 ? following(tooth_body.condensed(wave.angular_frequency, true))
                                 : following(condensation),
                             at_rest);
    const RingBody::Amplitude lift = tooth_ring.lift(
        [&](const double theta) { return std::polar(warp.amplitude, warp.n_waves * theta); });

    std::vector<RingBody::Displacement> displacements;
    for (const auto &[fields, sample, amplitude] : samples)
    {
      displacements.push_back(tooth_ring.at_rest());
      std::vector<unsigned int> pressed;
      std::vector<CondensationLoad> loads;
      for (unsigned int tooth = 0; tooth < n_teeth; ++tooth)
      {
        const double phase = wave.angular_frequency * fields.times[sample] -
                             2. * numbers::PI * wave.n_waves * tooth / n_teeth;
        tooth_ring.add(tooth, std::polar(amplitude / wave.amplitude, phase), free_motion,
                       displacements.back());
        const double angle = 2. * numbers::PI * tooth / n_teeth;
        tooth_ring.add(tooth, std::polar(1., warp.n_waves * angle), lift, displacements.back());

        Amplitudes forces(tooth_body.whole_top.origin.size());
        bool is_pressed = false;
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int c = 0; c < 3; ++c)
          {
            const double force = fields.state.force[fields.point(sample, tooth, a)][c];
            forces[mortar.nodes[a].tooth_node][c] = -force;
            is_pressed                            = is_pressed || force != 0.;
          }
        if (is_pressed && model.teeth_give_way)
        {
          pressed.push_back(tooth);
          for (CondensationLoad &load : loads_on_half(forces, tooth_body.whole_top))
            loads.push_back(std::move(load));
        }
      }
      const std::vector<SectorMotion> motions = condensation.interior(0, {}, loads);
      for (unsigned int i = 0; i < pressed.size(); ++i)
        tooth_ring.add(pressed[i], 1., tooth_ring.amplitude(motions[2 * i], motions[2 * i + 1]),
                       displacements.back());
    }
    return displacements;
  }
} // namespace ringmotor
