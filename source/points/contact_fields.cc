// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/contact_fields.h>

#include <algorithm>
#include <type_traits>

namespace ringmotor
{
  void ContactFields::reserve(const std::size_t n_samples)
  {
    const std::size_t n_now = times.size();
    for_each_array([&](auto &values) { values.reserve(values.size() / n_now * n_samples); }, *this);
  }

  void ContactFields::append(const ContactFields &later)
  {
    if (later.times.empty())
      return;
    for_each_array([](auto &to, const auto &from)
                   { to.insert(to.end(), from.begin(), from.end()); },
                   *this, later);
    n_repeating_teeth = later.n_repeating_teeth;
    time_step         = later.time_step;
    speed             = later.speed;
  }

  ContactFields fields_of(const OperatingState &state, const double first_time)
  {
    const RingContact &contact      = *state.contact;
    const ContactSolution &solution = state.solution;
    ContactFields fields;
    static_cast<StepState &>(fields) = solution;
    fields.memory                    = {};
    // The rotation may follow.
    fields.state.rigid.resize(contact.n_time_samples() * contact.n_rigid_motions());
    for (unsigned int sample = 0; sample < contact.n_time_samples(); ++sample)
      fields.times.push_back(first_time + sample * contact.time_step());
    fields.n_repeating_teeth = contact.n_repeating_teeth();
    fields.time_step         = contact.time_step();
    fields.tooth             = contact.tooth_motion(solution.state);
    fields.rotor             = contact.rotor_motion(solution.state);
    fields.modal             = state.modal_motion;
    fields.vibration         = state.vibration;
    return fields;
  }

  double ContactFields::largest_share() const
  {
    double largest = 0., whole = 0.;
    for (const PointVector &force : state.force)
    {
      largest = std::max(largest, force[0]);
      whole += force[0];
    }
    return whole > 0. ? largest / whole : 0.;
  }

  std::size_t ContactFields::n_bytes() const
  {
    std::size_t sum = 0;
    for_each_array(
        [&](const auto &values)
        { sum += values.size() * sizeof(typename std::decay_t<decltype(values)>::value_type); },
        *this);
    return sum;
  }

  void ContactFields::drop_values()
  {
    const double step = time_step;
    *this             = {};
    time_step         = step;
  }
} // namespace ringmotor
