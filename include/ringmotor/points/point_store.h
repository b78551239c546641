// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/curve_point.h>
#include <ringmotor/points/discretisation.h>

#include <memory>
#include <optional>

namespace ringmotor
{
  /** Stores operating points of one motor with one discretisation. */
  class PointMemory
  {
  public:
    virtual ~PointMemory() = default;
    /** The point that was found for a request, if there is one. */
    virtual std::optional<CurvePoint> recall(const PointRequest &request) = 0;
    /** Stores a point. */
    virtual void keep(const CurvePoint &point) = 0;
    /** Stores another form of a point that it has. */
    virtual void replace(const CurvePoint &point) = 0;
  };

  /** Stores what a search has computed, so that another run need not compute it again. */
  class PointStore
  {
  public:
    virtual ~PointStore() = default;

    /** The motor condensed on a mesh, if it is known. Collective.
     * @param modes_level of its vibrations; none if it has none */
    virtual std::optional<TimedMotor>
    recall_motor(const unsigned int level, const std::optional<unsigned int> &modes_level) = 0;
    /** Stores it; collective. */
    virtual void keep_motor(const unsigned int level,
                            const std::optional<unsigned int> &modes_level,
                            const CondensedMotor &motor) = 0;
    /** The points of a motor. @param parameters with the variation of @p discretisation */
    virtual std::unique_ptr<PointMemory> points(const Parameters &parameters,
                                                const Discretisation &discretisation) = 0;
  };
} // namespace ringmotor
