// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/contact_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/points/point_quantities.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double micrometre = 1e-6, milli = 1e-3;

    const char *name_of(const PointStatus status)
    {
      return status == PointStatus::open ? "open" : status == PointStatus::stick ? "stick" : "slip";
    }

    /** A contact point whose history is written. */
    struct Watched
    {
      unsigned int tooth, node;
    };

    /** The contact points nearest to the requested places. */
    std::vector<Watched> watched_points(const CondensedMotor &motor,
                                        const std::vector<HistoryPoint> &places)
    {
      std::vector<Watched> watched;
      double outermost = 0.;
      for (const CondensedMotor::Node &node : motor.nodes)
        outermost = std::max(outermost, node.radius);
      if (places.empty())
        for (unsigned int a = 0; a < motor.nodes.size(); ++a)
          if (motor.nodes[a].radius > outermost * (1. - 1e-6))
            watched.push_back({0, a});
      for (const HistoryPoint &place : places)
      {
        const double tooth  = std::round(place.tooth);
        const auto distance = [&](const CondensedMotor::Node &node)
        {
          const double angle = node.angle - (place.tooth - tooth) * motor.pitch();
          return std::hypot(node.radius - place.radius, node.radius * angle);
        };
        const auto nearest = std::min_element(motor.nodes.begin(), motor.nodes.end(),
                                              [&](const auto &a, const auto &b)
                                              { return distance(a) < distance(b); });
        watched.push_back({static_cast<unsigned int>(tooth) % motor.n_teeth,
                           static_cast<unsigned int>(nearest - motor.nodes.begin())});
      }
      return watched;
    }

    /** A time sample and a tooth that represent the watched tooth at a time. */
    struct Sight
    {
      double time;
      unsigned int sample, tooth;
    };

    /** The history of a tooth: in the steady state, one period from the teeth of a few time
     * samples. */
    std::vector<Sight> history_of(const unsigned int watched, const CondensedMotor &motor,
                                  const ContactFields &fields, const bool is_steady)
    {
      std::vector<Sight> sights;
      for (unsigned int m = 0; m < fields.times.size(); ++m)
        if (!is_steady)
          sights.push_back({fields.times[m], m, watched});
        else
          for (unsigned int tooth = 0; tooth < fields.n_repeating_teeth; ++tooth)
          {
            // Tooth i + j is in the state in which tooth i was n j alpha / omega ago.
            double time = fields.times[m] - motor.n_waves * (1. * tooth - watched) * motor.pitch() /
                                                motor.wave.angular_frequency;
            time -= motor.period() * std::floor(time / motor.period() + 1e-9);
            sights.push_back({time, m, tooth});
          }
      std::sort(sights.begin(), sights.end(),
                [](const Sight &a, const Sight &b) { return a.time < b.time; });
      return sights;
    }
  } // namespace

  void write_torque_speed(const std::string &path, const std::vector<CurvePoint> &points)
  {
    std::vector<NamedRow> rows;
    for (const CurvePoint &point : points)
    {
      NamedRow row{{"control", prescribed(point.request).name}};
      add_entries(row, quantities_of(point));
      row.insert(row.end(), {{"newton_iterations", point.n_iterations},
                             {"seconds", point.seconds},
                             {"certificate", point.largest_violation}});
      rows.push_back(row);
    }
    write_table(path, rows);
  }

  void write_history(const std::string &path, const CondensedMotor &motor,
                     const std::vector<CurvePoint> &points, const bool is_steady,
                     const std::vector<HistoryPoint> &places)
  {
    CsvTable table({"point", "time_us", "tooth", "node", "r_mm", "theta_deg", "force_n_N",
                    "force_t_N", "force_r_N", "gap_um", "slip_t_um", "slip_r_um", "tooth_n_um",
                    "tooth_t_um", "tooth_r_um", "rotor_n_um", "rotor_t_um", "rotor_r_um",
                    "status"});
    for (unsigned int p = 0; p < points.size(); ++p)
      for (const auto &[tooth, node] : watched_points(motor, places))
        for (const Sight &sight : history_of(tooth, motor, points[p].fields, is_steady))
        {
          const ContactFields &fields = points[p].fields;
          const std::size_t i         = fields.point(sight.sample, sight.tooth, node);
          std::vector<CsvTable::Entry> row{
              p,    sight.time / micrometre,          tooth,
              node, motor.nodes[node].radius / milli, motor.nodes[node].angle * 180. / numbers::PI};
          for (unsigned int c = 0; c < 3; ++c)
            row.push_back(fields.state.force[i][c]);
          for (const PointVector &vector : {fields.motion[i], fields.tooth[i], fields.rotor[i]})
            for (unsigned int c = 0; c < 3; ++c)
              row.push_back(vector[c] / micrometre);
          row.push_back(std::string(name_of(fields.status[i])));
          table.add_row(row);
        }
    table.write(path);
  }

  void write_lip(const std::string &path, const LipAmplification &lip,
                 const double angular_frequency)
  {
    constexpr unsigned int n_frequencies = 400; // up to that of the harmonic after the last one
    CsvTable table({"harmonic", "nodal_diameter", "frequency_kHz", "amplification"});
    for (unsigned int m = 1; m <= lip.n_harmonics(); ++m)
      for (unsigned int i = 0; i <= n_frequencies; ++i)
      {
        const double frequency = angular_frequency * (lip.n_harmonics() + 1.) * i / n_frequencies;
        table.add_row({m, lip.nodal_diameter(m), 1e-3 * frequency / (2. * numbers::PI),
                       lip.at(m, frequency)});
      }
    table.write(path);
  }
} // namespace ringmotor
