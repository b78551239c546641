// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/warp.h>
#include <ringmotor/points/contact_fields.h>
#include <ringmotor/points/curve_setting.h>
#include <ringmotor/points/loaded_wave.h>
#include <ringmotor/points/operating_point.h>
#include <ringmotor/points/point_error.h>
#include <ringmotor/points/rotor_energy.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
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
  };

  /** The causes of the errors of an operating point, as they are named in all outputs. */
  namespace causes
  {
    inline constexpr const char
        *meshes = "meshes of bodies and interface",
        *modes = "modes of rotor and teeth", *time_step = "time step",
        *scheme                = "dissipation of the scheme",
        *window                = "averaging window",   ///< see CurvePoint::window
            *wave              = "wave of the stator", ///< as estimated by the program `stator`
                *effects       = "effects left out",   ///< by `auto`
                    *algebra   = "algebra", ///< residual of the laws of contact and friction
                        *drive = "circuits of the phases"; ///< the numbers of VoltageDrive
    inline constexpr std::array<const char *, 9> all{
        {meshes, modes, time_step, scheme, window, wave, effects, algebra, drive}};
  } // namespace causes

  /** An operating point and the effort to find it. */
  struct CurvePoint
  {
    PointRequest request{};
    OperatingPoint result;
    std::vector<double> rotor_energies; ///< J, see rotor_energies()
    double rotor_power = 0.;            ///< W, see power_per_loss_factor()
    /** Error of the averaging window of a marched motor: how far the result is from its settled
     * value, if the point reports that. */
    PointError window;
    bool tells_window = false;
    std::map<std::string, PointError> errors; ///< by cause
    double largest_violation = 0.; ///< of the laws of contact and friction, see ContactCertificate
    /** What the search for the amplitude and the frequency of the wave leaves open, see StableRoot:
     * where the state jumps with them, the whole jump. */
    PointError unsettled;
    unsigned int n_iterations = 0;
    double seconds            = 0.;
    std::string remark; ///< what was tried if Newton's method alone did not suffice
    ContactFields fields;

    /** The sum of all causes. */
    PointError error() const;

    /** Adds what the solver reports of a state. */
    void add_certificate(const ContactSolution &solution);

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &request.control &request.value &result &window &tells_window &errors;
      archive &rotor_energies &rotor_power &largest_violation &unsettled &n_iterations &seconds
          &remark &fields;
    }
  };

  /** Stores operating points of a motor that have already been found. */
  class PointMemory
  {
  public:
    virtual ~PointMemory() = default;
    /** The point that was found for a request, if there is one. */
    virtual std::optional<CurvePoint> recall(const PointRequest &request) = 0;
    /** Stores a point. */
    virtual void keep(const CurvePoint &point) = 0;
  };

  /** Finds operating points of a motor, steady or by marching as its parameters request. Uses only
   * relevant_for_points() of the parameters. */
  class OperatingPointFinder
  {
  public:
    /** @p motor and @p memory, which is optional, must outlive this object. @p parameters must
     * match @p setting in the parts of a step, @p motor in all else. Without a @p drive the wave
     * has the amplitude of the motor, else the one that the drive gives it. */
    OperatingPointFinder(const Parameters &parameters, const CondensedMotor &motor,
                         PointMemory *memory = nullptr, const CurveSetting &setting = {},
                         const std::optional<VoltageDrive> &drive = {});

    /**
     * Looks in the memory first. The search for a steady state starts from that of @p start, of the
     * same or a similar request, or else from the previous point; from rest if @p start is a point
     * without fields. After a point from the memory, the next one is bitwise the same as if the
     * former had been computed.
     * @param start_before the start of the previous point: where that point is a better start, it
     * is changed by what has changed between the two starts
     * @throws ComputationError if none is found
     */
    CurvePoint find(const PointRequest &request, const CurvePoint *start = nullptr,
                    const CurvePoint *start_before = nullptr);

    /** The steady state with a wave of a given amplitude (m), whatever drives it, at the frequency
     * to which the contact shifts it if the model has it so; starts from the previous point.
     * @throws ComputationError if none is found */
    CurvePoint find_at(const PointRequest &request, const double of_wave);

  private:
    /** Sets the start of a steady state. */
    void begin(const PointRequest &request, const CurvePoint &start,
               const CurvePoint *start_before);
    /** The searches for amplitude and frequency of the wave begin with those of a point. */
    void begin_with_wave_of(const CurvePoint &start);
    CurvePoint find_steady(const PointRequest &request);
    /** The steady state with the wave at an amplitude (m) and a frequency (rad/s). */
    CurvePoint at_frequency(const PointRequest &request, const double of_wave, const double at);

    const CurveSetting setting;
    const Parameters parameters;
    const MotorModel model;
    const CondensedMotor &motor;
    const std::optional<VoltageDrive> drive;
    LoadedWave wave;
    double amplitude;     ///< m, at which the search for that of a driven wave begins
    double detuning = 0.; ///< see OperatingPoint, with which the search for the frequency begins
    PointMemory *const memory;
  };

  /** What the contact at a point does to a wave that @p drive drives, at a frequency (rad/s). */
  WaveLoad wave_load(const CurvePoint &point, const VoltageDrive &drive, const double frequency);

  /** The load on the rotor at a requested operating point. */
  RotorLoad load_of(const Loading &loading, const PointRequest &request);

  /** The parameters with shorter steps: with @p n_parts time samples in the steady state, with each
   * step divided into @p n_parts when marching. */
  Parameters with_parts_of_a_step(const Parameters &parameters, const unsigned int n_parts);

  /** The points that Loading/Values lists; none for a curve, see points_along_curve(). */
  std::vector<PointRequest> listed_points(const Loading &loading);

  /** Motors at several levels, each condensed by one of the ranks and known to all.
   * @param condense computes the motor of a level */
  std::vector<TimedMotor>
  condense_motors(const std::vector<unsigned int> &levels,
                  const std::function<CondensedMotor(unsigned int level)> &condense,
                  MPI_Comm communicator);

  /**
   * Finds several points with the steps of @p setting, distributed over the ranks of
   * @p communicator and returned on all of them. @p motor must have its mesh and wave. @p starts is
   * empty or has one for each request, see OperatingPointFinder::find(). @p after_point is called,
   * and @p memory consulted, on the rank that finds a point.
   */
  std::vector<CurvePoint>
  find_points(const Parameters &parameters, const CondensedMotor &motor,
              const CurveSetting &setting, const std::vector<PointRequest> &requests,
              MPI_Comm communicator, const std::function<void(const CurvePoint &)> &after_point,
              PointMemory *memory = nullptr, const std::vector<CurvePoint> &starts = {},
              const std::optional<VoltageDrive> &drive = {});
} // namespace ringmotor
