// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>
#include <ringmotor/points/discretisation.h>

#include <string>

namespace ringmotor
{
  /** Told how a search for operating points proceeds, on each rank for itself. */
  class Progress
  {
  public:
    virtual ~Progress() = default;

    /** A phase of the search begins, by name, and ends the one before. */
    virtual void enter(const std::string & /*phase*/) {}
    /** The last phase ends. */
    virtual void leave() {}

    /** A motor has been condensed, or read. */
    virtual void condensed(const unsigned int /*level*/, const CondensedMotor & /*motor*/) {}
    /** Meshes are refined to a level; the motor and the points of the last one took some seconds.
     */
    virtual void before_refinement(const unsigned int /*level*/, const double /*of_motor*/,
                                   const double /*of_points*/)
    {
    }
    /** Some operating points are computed next. */
    virtual void before_points(const Discretisation & /*discretisation*/,
                               const CondensedMotor & /*motor*/, const unsigned int /*n_points*/)
    {
    }
    /** One of them is known. */
    virtual void after_point(const CurvePoint & /*point*/) {}
  };
} // namespace ringmotor
