// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <ctime>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** Seconds of processor time of this process since its construction: unlike wall clock, they
   * barely depend on what else runs on the machine. */
  class ProcessorTime
  {
  public:
    double seconds() const { return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC; }

  private:
    std::clock_t begin = std::clock();
  };

  /** One setting of a discretisation: what it costs and what it gives. */
  struct StudyRow
  {
    std::string knob, value;     ///< what differs from the common setting, "degree", and how, "3"
    bool is_other_model = false; ///< its distances include the difference of two models
    std::vector<std::pair<std::string, unsigned int>> counts; ///< "dofs" and others, with names
    double seconds = 0.;                                      ///< of the processor
    /** By quantity, its values at all points; empty if the setting has no solution. */
    std::vector<std::vector<double>> results;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &knob &value &is_other_model &counts &seconds &results;
    }
  };

  /**
   * Work against precision: settings with their seconds and, for each quantity, their distance from
   * the best setting, which is the largest difference over all points, relative to a scale of the
   * quantity. The best setting itself, from which nothing is known of its own error, is neither on
   * a front nor the cheapest for a tolerance.
   */
  class WorkPrecision
  {
  public:
    /** A quantity in the order of StudyRow::results. */
    struct Measure
    {
      std::string name;
      double scale; ///< in the unit of the results, positive
    };

    /** @param best row, which must have results */
    WorkPrecision(std::vector<StudyRow> rows, std::vector<Measure> measures,
                  const unsigned int best);

    const std::vector<StudyRow> &rows() const { return all; }
    /** Those quantities that have values. */
    const std::vector<Measure> &quantities() const { return measures; }

    /** Relative; none if the row has no results. */
    std::optional<double> distance(const unsigned int row, const unsigned int quantity) const
    {
      return distances[row][quantity];
    }

    /** The row with the least seconds whose distance is within @p tolerance, if there is one. */
    std::optional<unsigned int> cheapest(const unsigned int quantity, const double tolerance) const;

    /** The Pareto front: rows than which no other is both cheaper and closer to the best, in the
     * order of their seconds. */
    std::vector<unsigned int> front(const unsigned int quantity) const;

    /** By how much the seconds of cheapest() grow from one tolerance to another; none if one of
     * them is not reached. */
    std::optional<double> price(const unsigned int quantity, const double from,
                                const double to) const;

  private:
    std::vector<StudyRow> all;
    std::vector<Measure> measures;
    unsigned int best;
    std::vector<std::vector<std::optional<double>>> distances; ///< by row and quantity
  };
} // namespace ringmotor
