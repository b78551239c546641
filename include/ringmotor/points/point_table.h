// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/points/point_source.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * Operating points by discretisation and request, which are computed when they are asked for, and
   * the motors that they need. Each search for a steady state starts from the best point that is
   * known: the same one with coarser modes, with longer steps, on another mesh, or a similar one of
   * the first curve or, once that is left, of the same discretisation; each marched point from the
   * most similar one.
   */
  class PointTable
  {
  public:
    /** @param source must outlive this object */
    PointTable(const Parameters &parameters, const StepChoice &steps, PointSource &source);

    /** Condenses the motors that are missing on some meshes; ranks share them. */
    void condense(const std::vector<unsigned int> &levels, const unsigned int modes_level);
    /** The motor on the meshes of a level. */
    const CondensedMotor &motor(const unsigned int level, const unsigned int modes_level);
    /** Drops the motors on coarser meshes, or with other modes. */
    void drop_motors(const unsigned int below_level, const unsigned int other_than_modes_level);

    /** Where points without a better start begin. */
    enum class Start
    {
      similar_point, ///< the nearest one of the first curve or else the one before; after it is
                     ///< left, the nearest one of the same discretisation
      rest
    };
    /** Requests by discretisation. */
    using Needs = std::vector<std::pair<Discretisation, std::vector<PointRequest>>>;
    /** Computes all points that are missing; ranks share them. */
    void fill(const Needs &needs, const Start start = Start::similar_point);
    /** The point of a request, computed if it is missing. */
    const CurvePoint &at(const Discretisation &discretisation, const PointRequest &request);
    /** The same if it is known; else null. */
    const CurvePoint *find(const Discretisation &discretisation, const PointRequest &request) const;
    /** Forgets all points but those of a first curve, from which others may start. */
    void begin_with(const Discretisation &discretisation, const std::vector<CurvePoint> &curve);
    /** Adds a point. */
    void insert(const Discretisation &discretisation, const CurvePoint &point)
    {
      points[discretisation][point.request] = point;
    }
    /** No point starts from the first curve any more: there are better ones. */
    void leave_first_curve()
    {
      first_curve.clear();
      first_curve_is_left = true;
    }
    /** Drops the fields of all points but these, as far as they are known: of marched points,
     * from whose fields nothing starts, they take much memory, here and where they are kept. If
     * those of these points are large, they are not kept either. */
    void drop_other_fields(const Needs &needs);
    /** Computes these points again where a store has no more fields of them. */
    void restore_fields(const Needs &needs);

    /** Seconds of the processor for all known points of a discretisation. */
    double seconds(const Discretisation &discretisation) const;
    /** Seconds (wall clock) that the motor on a mesh took. */
    double motor_seconds(const unsigned int level, const unsigned int modes_level) const;

  private:
    using Points    = std::vector<CurvePoint>;
    using ByRequest = std::map<PointRequest, CurvePoint>;
    /** One for each request; none where each is to start from the one before. */
    Points starts_for(const Discretisation &discretisation,
                      const std::vector<PointRequest> &requests, const Start start);
    std::optional<Points> known(const Discretisation &discretisation,
                                const std::vector<PointRequest> &requests) const;
    /** Known marched points of the motor that is not varied with the most similar loads, if
     * possible the same ones: on the same mesh, or else on another one. None where each is to begin
     * from rest. */
    Points marched_starts(const Discretisation &discretisation,
                          const std::vector<PointRequest> &requests);
    /** The most similar known points in the same discretisation, or that with the largest wave if a
     * voltage drives it; none if none is known. */
    Points similar_points(const Discretisation &discretisation,
                          const std::vector<PointRequest> &requests) const;
    Points starts_with_longer_steps(const Discretisation &discretisation,
                                    const std::vector<PointRequest> &requests, const Start start);
    /** Steps of twice the length, if they divide the pitch; of a varied motor, the requested one.
     */
    Discretisation with_longer_steps(const Discretisation &discretisation) const;
    /** The known point with the shortest steps that are longer; null without one. */
    const CurvePoint *point_with_longer_steps(const Discretisation &discretisation,
                                              const PointRequest &request) const;
    std::optional<Points> starts_on_other_mesh(const Discretisation &discretisation,
                                               const std::vector<PointRequest> &requests);
    /** The points of the first curve with the most similar loads, on this mesh. */
    Points starts_from_first_curve(const Discretisation &discretisation,
                                   const std::vector<PointRequest> &requests);
    /** Points found on the mesh of a level, with their fields on that of a discretisation. */
    Points transferred(Points starts, const unsigned int from_level,
                       const Discretisation &discretisation);
    /** Whether fields are small enough for the folder of kept points. */
    static bool may_be_kept(const std::size_t n_bytes);
    /** The one of some points with the most similar load. */
    static const CurvePoint &similar_point(const ByRequest &points, const PointRequest &request);
    /** Between the load of a point and that of a request. */
    static double distance(const CurvePoint &point, const PointRequest &request);

    const Parameters &parameters;
    const StepChoice steps;
    PointSource &source;
    /** By level of the modes, then of the meshes. */
    std::map<std::pair<unsigned int, unsigned int>, std::unique_ptr<const TimedMotor>> motors;
    std::map<Discretisation, ByRequest> points;
    ByRequest first_curve;
    unsigned int level_of_first_curve = 0; ///< of its mesh
    bool first_curve_is_left          = false;
  };
} // namespace ringmotor
