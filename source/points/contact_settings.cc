// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/points/contact_settings.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    constexpr double moderate_steps = 180.; // in a period of the steady state

    std::string steps_text(const double n_steps)
    {
      return std::to_string(std::lround(n_steps)) + " steps";
    }

    void write(std::ostream &text, const InterfaceGrading &grading)
    {
      text << grading.n_across << " x " << grading.n_around << " ratio " << grading.ratio;
    }

    /** A way in which a setting can differ from the common one. */
    struct Value
    {
      std::string text;
      std::function<void(ContactSetting &)> set;
    };
    struct Knob
    {
      std::string name;
      std::vector<Value> values;
    };

    /** A value for each of some numbers. */
    template <class Number, class Set>
    std::vector<Value> values_of(const std::vector<Number> &numbers, const Set &set)
    {
      std::vector<Value> values;
      for (const Number number : numbers)
        values.push_back(
            {short_text(number), [=](ContactSetting &setting) { set(setting, number); }});
      return values;
    }

    std::vector<Knob> mesh_knobs()
    {
      const auto both = [](auto member)
      {
        return [member](ContactSetting &setting, const auto value)
        { setting.discretisation.tooth.*member = setting.discretisation.lip.*member = value; };
      };
      return {
          {"degree", values_of<unsigned int>({1, 2, 3, 4},
                                             [](ContactSetting &setting, const unsigned int degree)
                                             { setting.discretisation.degree = degree; })},
          {"cells across the lip",
           values_of<unsigned int>({1, 2, 3, 4}, both(&InterfaceGrading::n_across))},
          {"cells around the tooth",
           values_of<unsigned int>({1, 2, 3}, both(&InterfaceGrading::n_around))},
          {"even cells across the lip",
           values_of<unsigned int>({1, 2, 4, 8},
                                   [](ContactSetting &setting, const unsigned int n_cells)
                                   {
                                     for (InterfaceGrading *grading :
                                          {&setting.discretisation.tooth,
                                           &setting.discretisation.lip})
                                       *grading = {n_cells, grading->n_around, 1.};
                                   })},
          {"ratio of the layers at edges",
           values_of<double>({0.05, 0.15, 0.3, 0.5}, both(&InterfaceGrading::ratio))},
          {"cells at the rotor's edges",
           values_of<double>({1., 0.5, 0.25, 0.1}, [](ContactSetting &setting, const double first)
                             { setting.discretisation.rotor.first = first; })}};
    }

    Knob flange_knob(const Parameters &parameters)
    {
      const bool is_shell = parameters.rotor.flange_element == ElementKind::shell;
      return {"flange",
              {{is_shell ? "solid" : "shell", [=](ContactSetting &setting)
                {
                  setting.parameters.rotor.flange_element =
                      is_shell ? ElementKind::solid : ElementKind::shell;
                  setting.is_other_model = true;
                }}}};
    }

    void set_springs(Contact &contact, const double normal, const double tangential)
    {
      contact.formulation        = ContactFormulation::penalty;
      contact.normal_penalty     = normal;
      contact.tangential_penalty = tangential;
    }

    /** Springs at the nodes as given or, if they are not, with a hundredth of the compliance of a
     * node. */
    Contact with_springs(const Parameters &parameters, const StudiedMotor &motor)
    {
      Contact contact        = parameters.contact;
      const double stiffness = 100. * motor.node_stiffness;
      set_springs(contact, contact.normal_penalty.value_or(stiffness),
                  contact.tangential_penalty.value_or(stiffness));
      return contact;
    }

    Knob contact_knob(const Parameters &parameters, const StudiedMotor &motor)
    {
      Knob knob{"contact", {{"mortar", [](ContactSetting &setting) {
                               setting.parameters.contact.formulation = ContactFormulation::mortar;
                             }}}};
      const Contact springs = with_springs(parameters, motor);
      for (const double factor : {10., 1., 0.1, 0.01})
        knob.values.push_back(
            {"springs of " + short_text(factor * *springs.normal_penalty) + " N/m",
             [=](ContactSetting &setting)
             {
               set_springs(setting.parameters.contact, factor * *springs.normal_penalty,
                           factor * *springs.tangential_penalty);
             }});
      return knob;
    }

    Knob steps_knob(const ContactSetting &common)
    {
      Knob knob{"steps per period", {}};
      for (const double factor : {0.25, 0.5, 1., 2., 4.})
      {
        const double n_steps = factor * common.n_steps;
        knob.values.push_back({std::to_string(std::lround(n_steps)),
                               [=](ContactSetting &setting) { setting.n_steps = n_steps; }});
      }
      return knob;
    }

    std::vector<Knob> inertia_knobs()
    {
      return {
          {"rotor modes",
           values_of<unsigned int>({1, 2, 3}, [](ContactSetting &setting, const unsigned int level)
                                   { setting.modes_level = level; })},
          {"spectral radius",
           values_of<double>({0., 0.5, 0.8, 0.95}, [](ContactSetting &setting, const double radius)
                             { setting.parameters.time.spectral_radius = radius; })}};
    }

    /** An average over some steps of a run, instead of periods of the settled motion. */
    void set_window(Time &time, const unsigned int from, const unsigned int to)
    {
      time.n_steps = time.average_to_step = to;
      time.average_from_step              = from;
    }

    void average_over_settled_periods(ContactSetting &setting)
    {
      constexpr double target = 3e-3; // means then settle to a tenth of it
      Time &time              = setting.parameters.time;
      time.n_steps = time.average_from_step = time.average_to_step = {};
      setting.parameters.accuracy.contact_target =
          std::min(target, setting.parameters.accuracy.contact_target);
    }

    Knob window_knob(const ContactSetting &common, const double period)
    {
      const auto n = static_cast<unsigned int>(
          std::max(2L, std::lround(period / common.parameters.time.time_step)));
      Knob knob{"averaging window", {{"settled periods", average_over_settled_periods}}};
      for (const unsigned int number : {1u, 2u, 4u})
        knob.values.push_back({"period " + std::to_string(number), [=](ContactSetting &setting) {
                                 set_window(setting.parameters.time, (number - 1) * n + 2,
                                            number * n + 1);
                               }});
      knob.values.push_back({"steps 6 to 15", [](ContactSetting &setting)
                             { set_window(setting.parameters.time, 6, 15); }});
      return knob;
    }

    std::vector<Knob> knobs_of(const ContactSetting &common, const StudiedMotor &motor)
    {
      const Parameters &parameters = common.parameters;
      const MotorModel model       = motor_model(parameters);
      std::vector<Knob> knobs      = mesh_knobs();
      if (parameters.rotor.has_dimensions())
        knobs.push_back(flange_knob(parameters));
      knobs.push_back(contact_knob(parameters, motor));
      knobs.push_back(steps_knob(common));
      if (model.has_ring_modes())
        for (const Knob &knob : inertia_knobs())
          knobs.push_back(knob);
      if (is_marched(parameters))
        knobs.push_back(window_knob(common, motor.period));
      return knobs;
    }

    /** The settings of a motor, collected. */
    class Collection
    {
    public:
      Collection(const Parameters &parameters, const StudiedMotor &motor)
          : motor(motor), is_fixed(parameters.accuracy.mode == AccuracyMode::fixed),
            finest_level(is_fixed ? parameters.accuracy.interface_refinement
                                  : ContactDiscretisation::finest_level -
                                        (motor_model(parameters).has_inertia() ? 1 : 0)),
            common(common_setting(parameters, motor.period))
      {
      }

      std::vector<ContactSetting> collect()
      {
        add(common);
        for (unsigned int level = 0; level <= finest_level; ++level)
          for (const double factor : {1., 2.})
            add(of_sequence(level, factor * common.n_steps));
        for (const Knob &knob : knobs_of(common, motor))
          for (const Value &value : knob.values)
          {
            ContactSetting setting = common;
            setting.knob           = knob.name;
            setting.value          = value.text;
            value.set(setting);
            add(setting);
          }
        if (!motor_model(common.parameters).needs_modes())
          add_those_of_the_paper();
        all.push_back(best(finest_level));
        all.back().knob  = "best setting";
        all.back().value = "";
        return all;
      }

    private:
      ContactSetting of_sequence(const unsigned int level, const double n_steps) const
      {
        ContactSetting setting = common;
        setting.knob           = "interface mesh";
        setting.value          = std::to_string(level) + ", " + steps_text(n_steps);
        setting.discretisation = ContactDiscretisation::level(level);
        setting.n_steps        = n_steps;
        return setting;
      }

      /** All as fine as the study goes, on a mesh of the sequence. */
      ContactSetting best(const unsigned int level) const
      {
        ContactSetting setting                 = of_sequence(level, 4. * common.n_steps);
        setting.parameters.contact.formulation = ContactFormulation::mortar;
        if (!is_fixed)
          setting.modes_level = RotorVibration::finest_level;
        if (is_marched(common.parameters))
          average_over_settled_periods(setting);
        return setting;
      }

      void add_those_of_the_paper()
      {
        const ContactDiscretisation coarse{1, {1, 1}, {1, 1}, {}, 0.};
        const ContactSetting fine = best(finest_level > 1 ? finest_level - 1 : finest_level);
        const unsigned int n_along =
            fine.discretisation.degree * fine.discretisation.tooth.n_around;
        const auto mesh = [&](ContactSetting &setting) { setting.discretisation = coarse; };
        // Contact lies along a line: where more nodes share it, each has a softer spring.
        const auto springs = [&](ContactSetting &setting, const double factor)
        {
          const Contact given = with_springs(common.parameters, motor);
          set_springs(setting.parameters.contact, *given.normal_penalty * factor,
                      *given.tangential_penalty * factor);
        };
        const auto steps = [&](ContactSetting &setting)
        {
          setting.parameters.time.scheme      = TimeScheme::marching;
          setting.parameters.time.time_step   = 5e-7;
          setting.parameters.time.n_snapshots = 1;
          setting.n_steps                     = motor.period / setting.parameters.time.time_step;
          average_over_settled_periods(setting);
        };
        const auto window = [&](ContactSetting &setting)
        {
          const double n_steps = setting.n_steps;
          steps(setting);
          set_window(setting.parameters.time, 6, 15);
          setting.n_steps = n_steps;
        };
        const auto add_row = [&](const std::string &value, const auto &change)
        {
          ContactSetting setting = fine;
          setting.knob           = "as in the paper";
          setting.value          = value;
          change(setting);
          add(setting);
        };
        add_row("", [&](ContactSetting &setting)
                { mesh(setting), springs(setting, 1.), steps(setting), window(setting); });
        add_row("its mesh alone", mesh);
        add_row("its springs alone",
                [&](ContactSetting &setting) { springs(setting, 1. / n_along); });
        add_row("its steps alone", steps);
        add_row("its window alone", window);
      }

      /** Adds a setting unless another one is the same, or it is too fine. */
      void add(const ContactSetting &setting)
      {
        if (!(is_fixed && is_too_fine(setting)) && texts.insert(setting.text()).second)
          all.push_back(setting);
      }

      bool is_too_fine(const ContactSetting &setting) const
      {
        const ContactDiscretisation &given = setting.discretisation,
                                    finest = ContactDiscretisation::level(finest_level);
        return given.degree > finest.degree || given.lip.n_across > finest.lip.n_across ||
               given.lip.n_around > finest.lip.n_around || given.rotor.first < finest.rotor.first ||
               setting.modes_level > common.modes_level;
      }

      const StudiedMotor motor;
      const bool is_fixed;
      const unsigned int finest_level;
      const ContactSetting common;
      std::vector<ContactSetting> all;
      std::set<std::string> texts; ///< of all
    };
  } // namespace

  std::string ContactSetting::text() const
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << text_of(relevant_for_points(parameters)) << "degree " << discretisation.degree
         << "\ntooth ";
    write(text, discretisation.tooth);
    text << "\nlip ";
    write(text, discretisation.lip);
    const RotorGrading &rotor = discretisation.rotor;
    text << "\nrotor " << rotor.first << ", " << rotor.ratio << ", " << rotor.longest << ", "
         << rotor.n_span << ", " << rotor.n_lip << "\nmodes " << modes_level << "\nsteps "
         << n_steps << "\n";
    return text.str();
  }

  ContactSetting common_setting(const Parameters &parameters, const double period)
  {
    ContactSetting common{"common setting",
                          "",
                          false,
                          parameters,
                          ContactDiscretisation::level(1),
                          moderate_steps,
                          RotorVibration::usual_level};
    if (is_marched(parameters))
      common.n_steps = period / parameters.time.time_step * parameters.time.n_snapshots;
    if (parameters.accuracy.mode == AccuracyMode::fixed)
    {
      common.modes_level = parameters.accuracy.rotor_modes;
      if (parameters.accuracy.interface_refinement == 0)
        common.discretisation = ContactDiscretisation::level(0);
    }
    return common;
  }

  std::vector<ContactSetting> contact_settings(const Parameters &parameters,
                                               const StudiedMotor &motor)
  {
    return Collection(parameters, motor).collect();
  }
} // namespace ringmotor
