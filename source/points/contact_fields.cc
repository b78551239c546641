// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/contact_fields.h>

namespace ringmotor
{
  void ContactFields::reserve(const std::size_t n_samples)
  {
    const std::size_t n_now = times.size();
    const auto reserve = [&](auto &values) { values.reserve(values.size() / n_now * n_samples); };
    reserve(times);
    reserve(force);
    reserve(motion);
    reserve(tooth);
    reserve(rotor);
    reserve(modal);
    reserve(vibration);
    reserve(rigid);
    reserve(status);
  }

  void ContactFields::append(const ContactFields &later)
  {
    if (later.times.empty())
      return;
    const auto append = [](auto &to, const auto &from)
    { to.insert(to.end(), from.begin(), from.end()); };
    append(times, later.times);
    append(force, later.force);
    append(motion, later.motion);
    append(tooth, later.tooth);
    append(rotor, later.rotor);
    append(modal, later.modal);
    append(vibration, later.vibration);
    append(rigid, later.rigid);
    append(status, later.status);
    n_repeating_teeth = later.n_repeating_teeth;
    time_step         = later.time_step;
    turn              = later.turn;
  }

  ContactFields fields_of(const OperatingState &state, const double first_time)
  {
    const RingContact &contact      = *state.contact;
    const ContactSolution &solution = state.solution;
    ContactFields fields;
    for (unsigned int sample = 0; sample < contact.n_time_samples(); ++sample)
      fields.times.push_back(first_time + sample * contact.time_step());
    fields.n_repeating_teeth         = contact.n_repeating_teeth();
    fields.time_step                 = contact.time_step();
    fields.force                     = solution.state.force;
    fields.motion                    = solution.motion;
    fields.tooth                     = contact.tooth_motion(solution.state);
    fields.rotor                     = contact.rotor_motion(solution.state);
    fields.modal                     = state.modal_motion;
    fields.vibration                 = state.vibration;
    const std::vector<double> &rigid = solution.state.rigid; // a turn may follow
    const std::size_t size           = contact.n_time_samples() * contact.n_rigid_motions();
    fields.rigid.assign(rigid.begin(), rigid.begin() + size);
    fields.turn = rigid.size() > size ? rigid.back() : 0.;
    for (const PointStatus status : solution.status)
      fields.status.push_back(static_cast<unsigned char>(status));
    return fields;
  }
} // namespace ringmotor
