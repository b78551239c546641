// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/steady.h>
#include <ringmotor/motor/warp.h>
#include <ringmotor/quantities/contact_fields.h>
#include <ringmotor/quantities/curve_setting.h>
#include <ringmotor/quantities/operating_point.h>
#include <ringmotor/quantities/rotor_energy.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ringmotor
{
  /** An operating point that is asked for. */
  struct PointRequest
  {
    Control control;
    double value; ///< N m or rad/s

    bool operator==(const PointRequest &other) const
    {
      return control == other.control && value == other.value;
    }
  };

  /** Errors of an operating point; what is prescribed has none. */
  struct PointError
  {
    double speed = 0., torque = 0., loss = 0.; ///< rad/s, N m, W
    double rotor_power = 0.;                   ///< W, see power_per_loss_factor()

    static const std::array<double PointError::*, 4> members;

    PointError &operator*=(const double factor)
    {
      for (double PointError::*const member : members)
        this->*member *= factor;
      return *this;
    }
    PointError &operator+=(const PointError &other)
    {
      for (double PointError::*const member : members)
        this->*member += other.*member;
      return *this;
    }

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      for (double PointError::*const member : members)
        archive &this->*member;
    }
  };

  inline constexpr std::array<double PointError::*, 4> PointError::members{
      {&PointError::speed, &PointError::torque, &PointError::loss, &PointError::rotor_power}};

  /** The error bars of an operating point by their causes. */
  struct PointErrors
  {
    PointError mesh;    ///< meshes of bodies and interface
    PointError modes;   ///< of a rotor with inertia: their mesh and their number
    PointError time;    ///< time step
    PointError scheme;  ///< dissipation of the scheme that steps what has inertia
    PointError window;  ///< see CurvePoint::window
    PointError wave;    ///< the stator's wave, as the program `stator` knows it
    PointError effects; ///< left out by `auto`
    PointError algebra; ///< what the solver leaves of the laws of contact and friction

    static constexpr const char *by_wave = "wave of the stator"; ///< name of that cause
    /** All members with their names. */
    static const std::vector<std::pair<std::string, PointError PointErrors::*>> &members();
    /** Each of them with its name. */
    std::vector<std::pair<std::string, PointError>> causes() const;
    /** The sum of all. */
    PointError total() const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      for (const auto &[cause, member] : members())
        archive &this->*member;
    }
  };

  /** An operating point and what it took to find it. */
  struct CurvePoint
  {
    PointRequest request{};
    OperatingPoint result;
    std::vector<double> rotor_energies; ///< J, see rotor_energies()
    double rotor_power = 0.;            ///< W, see power_per_loss_factor()
    /** By the steps that a marched motor is averaged over: how far the result is from where it
     * settles, if the point tells that. */
    PointError window;
    bool tells_window = false;
    PointErrors errors;
    double largest_violation  = 0.; ///< of the laws of contact and friction, see ContactCertificate
    unsigned int n_iterations = 0;
    double seconds            = 0.;
    std::string remark; ///< what was tried if Newton's method alone did not do
    ContactFields fields;

    /** Takes in what the solver tells of a state. */
    void add_certificate(const ContactSolution &solution);

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &request.control &request.value &result &window &tells_window &errors;
      archive &rotor_energies &rotor_power &largest_violation &n_iterations &seconds &remark
          &fields;
    }
  };

  /** Knows operating points of a motor that have been found already. */
  class PointMemory
  {
  public:
    virtual ~PointMemory() = default;
    /** The point that was found for a request, if there is one. */
    virtual std::optional<CurvePoint> recall(const PointRequest &request) = 0;
    /** Remembers a point. */
    virtual void keep(const CurvePoint &point) = 0;
  };

  /** Finds operating points of a motor, in the way (steady or marching) that its parameters ask
   * for. Looks at relevant_for_points() of the parameters only. */
  class OperatingPointFinder
  {
  public:
    /** @p motor and @p memory, which may be left out, must outlive this object. What
     * @p setting says must hold of them: the parts of a step of @p parameters, the others of
     * @p motor. */
    OperatingPointFinder(const Parameters &parameters, const CondensedMotor &motor,
                         PointMemory *memory = nullptr, const CurveSetting &setting = {});

    /**
     * Asks the memory first. A steady state is looked for from that of @p start, of the same
     * request, or else from the point before. The next point is found as if this one had been
     * computed, to the last bit.
     * @throws ComputationError if none is found
     */
    CurvePoint find(const PointRequest &request, const CurvePoint *start = nullptr);

  private:
    CurvePoint find_steady(const PointRequest &request);
    /** A steady state in which the wave has the frequency that the contact gives it. */
    OperatingState at_own_frequency(const RotorLoad &load);

    const CurveSetting setting;
    const Parameters parameters;
    const MotorModel model;
    const CondensedMotor &motor;
    SteadyDriver steady;
    std::unique_ptr<CondensedMotor> detuned; ///< the motor, with that frequency
    PointMemory *const memory;
  };

  /** What loads the rotor at an operating point that is asked for. */
  RotorLoad load_of(const Loading &loading, const PointRequest &request);

  /** The parameters with a step of a part of its length: of the steady state, with so many samples;
   * when marching, with each step divided by so much. */
  Parameters with_parts_of_a_step(const Parameters &parameters, const unsigned int n_parts);

  /** The points that Loading/Values lists; none of a curve, see points_along_curve(). */
  std::vector<PointRequest> listed_points(const Loading &loading);

  /**
   * Finds several points with the steps of @p setting, spread over the ranks of @p communicator;
   * all of them end up on each rank. @p motor is of its mesh and its wave. @p starts has none or as
   * many points as requests, to start from. @p after_point is called, and @p memory asked, on the
   * rank that finds a point.
   */
  std::vector<CurvePoint>
  find_points(const Parameters &parameters, const CondensedMotor &motor,
              const CurveSetting &setting, const std::vector<PointRequest> &requests,
              MPI_Comm communicator, const std::function<void(const CurvePoint &)> &after_point,
              PointMemory *memory = nullptr, const std::vector<CurvePoint> &starts = {});

  /** By how much a point changes from one discretisation, or one wave, to another. What is
   * prescribed does not change. */
  PointError change(const CurvePoint &from, const CurvePoint &to);
} // namespace ringmotor
