// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/declare.h>
#include <ringmotor/parameters/run_control.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    Notation<std::vector<HistoryPoint>> history_point_list()
    {
      using Points                 = std::vector<HistoryPoint>;
      const std::string edge       = "outer edge";
      const Notation<double> tooth = non_negative_number(), radius = positive_number();
      const auto write = [=](const Points &points)
      {
        std::string text;
        for (const HistoryPoint &point : points)
          text += (text.empty() ? "" : ", ") + tooth.write(point.tooth) + ":" +
                  radius.write(point.radius);
        return text.empty() ? edge : text;
      };
      const auto read = [=](const std::string &text) -> std::optional<Points>
      {
        Points points;
        if (text == edge)
          return points;
        for (const std::string &item : items_of(text))
        {
          const std::vector<std::string> parts = Utilities::split_string_list(item, ':');
          if (parts.size() != 2 || !tooth.read(parts[0]) || !radius.read(parts[1]))
            return {};
          points.push_back({*tooth.read(parts[0]), *radius.read(parts[1])});
        }
        return points.empty() ? std::nullopt : std::make_optional(points);
      };
      return {write, read,
              edge + ", or places TOOTH:RADIUS separated by commas, such as 0:0.0342, 12.25:0.034"};
    }

    /** The name of a quantity as users write it: `teeth in contact`. */
    Notation<std::string> quantity_name()
    {
      std::vector<std::pair<std::string, std::string>> words;
      for (const std::string &name : held_quantities())
      {
        std::string word = name.substr(0, name.find("_per_"));
        std::replace(word.begin(), word.end(), '_', ' ');
        words.emplace_back(word, name);
      }
      return selection<std::string>(words);
    }

    /** Names, each with a target of its own where it has one, or the word that stands for all. */
    Notation<std::vector<QuantityTarget>> quantity_list(const Notation<double> &target)
    {
      using Targets                    = std::vector<QuantityTarget>;
      const std::string all            = "all";
      const Notation<std::string> name = quantity_name();
      Targets everything;
      for (const std::string &quantity : held_quantities())
        everything.push_back({quantity, {}});
      const auto write_list = [=](const Targets &targets)
      {
        std::string text;
        for (const QuantityTarget &held : targets)
          text += (text.empty() ? "" : ", ") + name.write(held.quantity) +
                  (held.target ? ":" + target.write(*held.target) : "");
        return text;
      };
      const auto write = [=](const Targets &targets)
      { return write_list(targets) == write_list(everything) ? all : write_list(targets); };
      const auto read = [=](const std::string &text) -> std::optional<Targets>
      {
        if (text == all)
          return everything;
        Targets targets;
        for (const std::string &item : items_of(text))
        {
          const std::vector<std::string> parts = Utilities::split_string_list(item, ':');
          const std::size_t n_colons           = std::count(item.begin(), item.end(), ':');
          if (n_colons > 1 || parts.size() != 1 + n_colons || !name.read(parts[0]))
            return {};
          targets.push_back({*name.read(parts[0]), {}});
          if (parts.size() == 2 && !(targets.back().target = target.read(parts[1])))
            return {};
          for (std::size_t other = 0; other + 1 < targets.size(); ++other)
            if (targets[other].quantity == targets.back().quantity)
              return {};
        }
        return targets.empty() ? std::nullopt : std::make_optional(targets);
      };
      return {write, read,
              all + ", or some of " + write_list(everything) +
                  ", each once and, if wanted, with a target of its own, such as speed, friction "
                  "loss:0.1"};
    }
  } // namespace

  const std::vector<std::string> &held_quantities()
  {
    static const std::vector<std::string> names{"speed", "torque", "friction_loss",
                                                "stick_fraction", "teeth_in_contact_per_wave"};
    return names;
  }

  double Accuracy::strictest_target() const
  {
    double strictest = 1.;
    for (const QuantityTarget &held : quantities)
      strictest = std::min(strictest, target_of(held));
    return strictest;
  }

  std::string Accuracy::names_of_quantities() const
  {
    std::string names;
    for (const QuantityTarget &held : quantities)
      names += (names.empty() ? "" : ", ") + quantity_name().write(held.quantity);
    return names;
  }

  void Accuracy::declare(ParameterHandler &prm)
  {
    add_entry(
        prm, "Target", target, number_within(1.e-8, 0.1, "a number from 1e-8 to 0.1"),
        "Admissible relative error of frequencies; Contact target may require a smaller one for a "
        "stator. Units: none.");
    const Notation<double> of_contact = number_within(1.e-3, 0.5, "a number from 1e-3 to 0.5");
    add_entry(
        prm, "Contact target", contact_target, of_contact,
        "The same for the quantities below: for speed and torque relative to the no-load speed "
        "and the stall torque, or to half the speed of the wave's crests and half the torque "
        "limit of sliding friction, if larger; the program stator refines until the error of the "
        "wave is at most a fifth of it. Units: none.");
    add_entry(prm, "Quantities", quantities, quantity_list(of_contact),
              "Which quantities of the operating points must meet Contact target; friction loss "
              "and teeth in contact relative to their largest values, the stick fraction as it "
              "is. All others also get error bars. Units: none.");
    add_entry(prm, "Time limit", time_limit, number_or("none", positive_number()),
              "Time after which the programs stator and contact stop; contact keeps the operating "
              "points found so far, and --resume continues from there. Units: s.");
    add_entry(prm, "Mode", mode,
              selection<AccuracyMode>(
                  {{"adaptive", AccuracyMode::adaptive}, {"fixed", AccuracyMode::fixed}}),
              "Refine until the target is met, or use the entries below.");
    add_entry(prm, "Polynomial degree", polynomial_degree, whole_number(2, 8),
              "Degree of the elements of the program stator; used with Mode = fixed only.");
    add_entry(prm, "Refinement", refinement, whole_number(0, 6),
              "Refinements of the mesh of the program stator; used with Mode = fixed only.");
    add_entry(
        prm, "Interface refinement", interface_refinement, whole_number(0, 4),
        "Place in the sequence of meshes and degrees of the bodies in contact; used with Mode = "
        "fixed only.");
    add_entry(
        prm, "Rotor modes", rotor_modes, whole_number(1, 3),
        "Accuracy of the vibrations of a rotor with inertia: finer and finer meshes for the first "
        "13, 20 or 30 of 45, 45 or 60 harmonics of the wave; used with Mode = fixed only.");
  }

  void Uncertainty::declare(ParameterHandler &prm)
  {
    const Notation<double> deviation = number_within(0., 0.5, "a number from 0 to 0.5");
    add_entry(prm, "Loss factors", loss_factors, deviation,
              "Relative standard deviation of the loss factor of each material, here and below "
              "for samples of motors by scripts/sweep.py --uncertainty. Units: none.");
    add_entry(prm, "Friction", friction, deviation,
              "That of the coefficients of friction, which vary together. Units: none.");
    add_entry(prm, "Young moduli", young_moduli, deviation,
              "That of the Young modulus of each material. Units: none.");
  }

  Effects::Effects()
  {
    for (const EffectEntry &entry : effect_entries())
      choices[entry.name] = entry.unless_given;
  }

  EffectChoice &Effects::operator[](const std::string &name)
  {
    Assert(choices.count(name) > 0, ExcMessage(name + " is no effect"));
    return choices[name];
  }

  EffectChoice Effects::operator[](const std::string &name) const
  {
    Assert(choices.count(name) > 0, ExcMessage(name + " is no effect"));
    return choices.at(name);
  }

  void Effects::declare(ParameterHandler &prm)
  {
    for (const EffectEntry &entry : effect_entries())
    {
      std::vector<std::pair<std::string, EffectChoice>> words{{"off", EffectChoice::off},
                                                              {"on", EffectChoice::on}};
      if (entry.has_auto)
        words.emplace_back("auto", EffectChoice::automatic);
      add_entry(prm, entry.name, choices[entry.name], selection<EffectChoice>(words),
                entry.sentence);
    }
  }

  void Output::declare(ParameterHandler &prm)
  {
    add_entry(prm, "Directory", directory, path(),
              "Folder of the results, with a subfolder for each program; a relative path "
              "starts in the current directory, and \"auto\" means output/ and the name of the "
              "parameter file.");
    add_entry(prm, "VTU", vtu, yes_or_no(), "Write fields for ParaView.");
    add_entry(prm, "Frames per period", frames_per_period, whole_number(2, 360),
              "Number of frames of one period in animations.");
    add_entry(
        prm, "History points", history_points, history_point_list(),
        "Where history.csv records forces and motion against time: at the outer edge of tooth 0, "
        "or at the contact nodes nearest to these places; 2.25:0.034 is a quarter of a pitch "
        "beyond the centre of tooth 2. Units: pitches for TOOTH and m for RADIUS.");
    add_entry(prm, "Figures", figures, yes_or_no(), "Draw the figures at the end of a run.");
  }
} // namespace ringmotor
