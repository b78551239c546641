// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/pictures/motor_bodies.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** The sum of modes of a half sector, each with a complex amplitude. */
    class ModalSum
    {
    public:
      explicit ModalSum(const CyclicSector &sector) : one(sector.at_rest()), i(sector.at_rest()) {}

      void add(const Complex &amplitude, const SectorMotion &mode)
      {
        add(amplitude.real(), mode, one);
        add(amplitude.imag(), mode, i);
      }

      SectorMotion one, i; ///< the sum is the first and, times i, the second

    private:
      static void add(const double factor, const SectorMotion &mode, SectorMotion &sum)
      {
        const auto from = mode.parts();
        const auto to   = sum.parts();
        for (unsigned int part = 0; part < to.size(); ++part)
          if (from[part]->real.size() > 0)
          {
            to[part]->real.add(factor, from[part]->real);
            to[part]->imaginary.add(factor, from[part]->imaginary);
          }
      }
    };

    /** The amplitudes of the modes at time samples of operating points. */
    class VibrationAmplitudes
    {
    public:
      VibrationAmplitudes(const RingModes &modes, const std::vector<PointSample> &samples)
          : first(1, 0), samples(samples)
      {
        for (const auto &of_diameter : modes)
          first.push_back(first.back() + of_diameter.size());
        for (const PointSample &at : samples)
          AssertThrow(at.fields.vibration.size() == at.fields.times.size() * first.back(),
                      ExcMessage("the amplitudes of the modes are missing"));
      }

      /** Of the modes of a nodal diameter, one after the other, at a sample. */
      const Complex *of(const std::size_t sample, const unsigned int k) const
      {
        return samples[sample].fields.vibration.data() + samples[sample].sample * first.back() +
               first[k];
      }

      /** Whether modes of a nodal diameter move at any sample. */
      bool any(const unsigned int k) const
      {
        for (std::size_t sample = 0; sample < samples.size(); ++sample)
          if (std::any_of(of(sample, k), of(sample, k) + first[k + 1] - first[k],
                          [](const Complex &amplitude) { return amplitude != 0.; }))
            return true;
        return false;
      }

    private:
      std::vector<std::size_t> first; ///< by nodal diameter
      const std::vector<PointSample> &samples;
    };

    /** The sign of a mode that was found again relative to the known one; 0 if it is another. */
    double relative_sign(const RingMode &found, const RingMode &known)
    {
      constexpr double tolerance                        = 1e-4;
      const std::vector<std::array<Complex, 3>> &motion = known.motion_of_body();
      double product = 0., of_found = 0., of_known = 0.;
      for (std::size_t a = 0; a < motion.size(); ++a)
        for (unsigned int c = 0; c < 3; ++c)
        {
          product += (std::conj(motion[a][c]) * found.motion[a][c]).real();
          of_found += std::norm(found.motion[a][c]);
          of_known += std::norm(motion[a][c]);
        }
      if (!known.of_rotor() || std::abs(product) < (1. - tolerance) * std::max(of_found, of_known))
        return 0.;
      return product < 0. ? -1. : 1.;
    }
  } // namespace

  std::vector<unsigned int> MotorBodies::keepers(const RotorModeSolver &solver) const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(ranks),
                       rank    = Utilities::MPI::this_mpi_process(ranks);
    std::vector<unsigned int> first(parameters.motor.n_teeth / 2 + 1, n_ranks);
    for (const auto &[k, harmonics] : solver.diameters())
      if (solver.has_kept(k))
        first[k] = rank;
    Utilities::MPI::min(first, ranks, first);
    std::replace(first.begin(), first.end(), n_ranks, numbers::invalid_unsigned_int);
    return first;
  }

  std::vector<Mode> MotorBodies::modes_of(const CondensedMotor &motor, const unsigned int k,
                                          RotorModeSolver &solver,
                                          const MortarCoupling &of_modes) const
  {
    std::vector<Mode> modes            = solver.modes(k);
    const std::vector<RingMode> &known = motor.modes[k];
    const auto n_known =
        std::count_if(known.begin(), known.end(), [](const auto &mode) { return mode.of_rotor(); });
    bool are_those = modes.size() == static_cast<std::size_t>(n_known);
    for (std::size_t r = 0; are_those && r < modes.size(); ++r)
    {
      const LipModes::LipMode on_lip =
          LipModes::on_lip(solver.body, modes[r], model.rotor_gives_way_along);
      const double sign = relative_sign(
          LipModes::at_points(on_lip, solver.body.whole_lip, of_modes, k * motor.pitch()),
          known[r]);
      modes[r].motion *= sign * std::sqrt(0.5); // two halves make a sector
      are_those = sign != 0.;
    }
    if (!are_those)
      throw ComputationError("the vibrations of the rotor with " + std::to_string(k) +
                             " nodal diameters differ from those of the motor");
    return modes;
  }

  void MotorBodies::add_vibration(const CondensedMotor &motor, const RotorVibration &vibration,
                                  const std::vector<PointSample> &samples,
                                  std::vector<RingBody::Displacement> &displacements) const
  {
    const VibrationAmplitudes amplitudes(motor.modes, samples);
    for (const auto &solver : vibration.solvers(vibration.setting(motor.modes_level)))
    {
      const RotorBody &body          = solver->body;
      const RingBody::Samples points = rotor_ring.samples_in(body.sector);
      const MortarCoupling of_modes =
          couple(tooth_body.whole_top.surface, body.whole_lip.surface, motor.pitch(), lip_turn);
      const auto add = [&](const unsigned int k)
      {
        const std::vector<Mode> modes = modes_of(motor, k, *solver, of_modes);
        // Waves k and N - k are conjugate to each other; here one stands for both.
        const double weight = k == 0 || 2 * k == motor.n_teeth ? 1. : 2.;
        for (std::size_t sample = 0; sample < samples.size(); ++sample)
        {
          ModalSum sum(body.sector);
          for (std::size_t r = 0; r < modes.size(); ++r)
            sum.add(weight * amplitudes.of(sample, k)[r], modes[r].motion);
          const RingBody::Amplitude amplitude = rotor_ring.amplitude(sum.one, sum.i, points);
          for (unsigned int sector = 0; sector < motor.n_teeth; ++sector)
            rotor_ring.add(sector, std::polar(1., -motor.pitch() * k * sector), amplitude,
                           displacements[sample]);
        }
      };
      const std::vector<unsigned int> keeper = keepers(*solver);
      std::vector<unsigned int> to_be_found;
      for (const auto &[k, harmonics] : solver->diameters())
        if (amplitudes.any(k))
        {
          if (keeper[k] == Utilities::MPI::this_mpi_process(ranks))
            add(k);
          else if (keeper[k] == numbers::invalid_unsigned_int)
            to_be_found.push_back(k);
        }
      TaskQueue diameters(to_be_found.size(), ranks);
      for (std::size_t task; diameters.take(task);)
        add(to_be_found[task]);
      diameters.finish();
    }
  }
} // namespace ringmotor
