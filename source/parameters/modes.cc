// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/modes.h>

#include <set>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using NodalDiameters = std::vector<unsigned int>;

    /** Ascending numbers as ranges: "0-3, 7". */
    std::string ranges_text(const NodalDiameters &numbers)
    {
      std::string text;
      for (std::size_t first = 0, last = 0; first < numbers.size(); first = last + 1)
      {
        for (last = first; last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1;)
          ++last;
        text += (first == 0 ? "" : ", ") + std::to_string(numbers[first]);
        if (last > first)
          text += "-" + std::to_string(numbers[last]);
      }
      return text;
    }

    std::optional<NodalDiameters> numbers_in_ranges(const std::string &text)
    {
      const Notation<unsigned int> number = whole_number(0, 5000);
      std::set<unsigned int> numbers;
      for (const std::string &range : Utilities::split_string_list(text, ','))
      {
        const std::size_t dash = range.find('-');
        const auto first       = number.read(range.substr(0, dash));
        const auto last = dash == std::string::npos ? first : number.read(range.substr(dash + 1));
        if (!first || !last || *last < *first)
          return {};
        for (unsigned int value = *first; value <= *last; ++value)
          numbers.insert(value);
      }
      if (numbers.empty())
        return {};
      return NodalDiameters(numbers.begin(), numbers.end());
    }

    Notation<NodalDiameters> nodal_diameter_list()
    {
      const NodalDiameters all = {Modes::all_nodal_diameters}, of_wave;
      const auto write         = [=](const NodalDiameters &numbers) {
        return numbers == of_wave ? "wave" : numbers == all ? "all" : ranges_text(numbers);
      };
      const auto read = [=](const std::string &text) {
        return text == "wave" ? of_wave : text == "all" ? all : numbers_in_ranges(text);
      };
      return {write, read,
              "wave, all, or whole numbers and ranges from 0 to half the number of teeth, such as "
              "\"7\", \"0-12\" or \"2, 5-7\""};
    }
  } // namespace

  std::string to_string(const Body body)
  {
    return body == Body::stator ? "stator" : body == Body::rotor ? "rotor" : "tooth";
  }

  void Modes::declare(ParameterHandler &prm)
  {
    add_entry(
        prm, "Body", body,
        selection<Body>({{"stator", Body::stator}, {"rotor", Body::rotor}, {"tooth", Body::tooth}}),
        "The body whose modes are computed.");
    add_entry(
        prm, "Domain", domain,
        selection<Domain>({{"sector", Domain::sector}, {"ring", Domain::ring}}),
        "What is meshed: one sector of a ring of equal sectors, or the whole ring, which need "
        "not have equal sectors.");
    add_entry(prm, "Nodal diameters", nodal_diameters, nodal_diameter_list(),
              "The numbers of waves around the ring for which modes are computed; \"wave\" means "
              "that of the motor.");
    add_entry(prm, "Number of modes", n_modes, whole_number(1, 1000),
              "Number of elastic modes for each nodal diameter, or of the whole ring.");
    add_entry(prm, "Frequency target", frequency_target, plausible(non_negative_number(), 10., 1e7),
              "The modes nearest to this frequency are computed; 0 selects the lowest elastic "
              "ones. Units: Hz.");
  }

  void Wave::declare(ParameterHandler &prm)
  {
    add_entry(prm, "Drive", drive,
              selection<Drive>({{"amplitude", Drive::amplitude}, {"voltage", Drive::voltage}}),
              "What is given of the wave: its amplitude, or the voltage of both phases, from which "
              "the amplitude at each operating point follows.");
    add_entry(prm, "Amplitude", amplitude, plausible(positive_number(), 1e-10, 1e-3),
              "Normal amplitude of the wave at the outer edge of the tooth tops, zero to peak; "
              "with Drive = voltage that from which the wave grows or decays until forces balance. "
              "Units: m.",
              Presence::required);
    add_entry(prm, "Voltage", voltage, number_or("none", plausible(positive_number(), 0.01, 1e4)),
              "Voltage of each phase, zero to peak, for Drive = voltage; the phases are a quarter "
              "of a period apart. Units: V.");
    add_entry(prm, "Frequency", frequency,
              number_or("mode", plausible(positive_number(), 1e3, 1e7)),
              "Frequency at which the motor is driven; \"mode\" selects the computed frequency of "
              "the driving mode and, with Drive = voltage, a drive that follows the resonance. "
              "Units: Hz.");
    add_entry(prm, "Response torques", response_torques, numbers_or("none", any_number()),
              "Torques for which the response to the frequency at the given voltage is computed "
              "besides, with Drive = voltage. Units: N m.");
  }
} // namespace ringmotor
