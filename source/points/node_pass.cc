// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/points/node_pass.h>

namespace ringmotor
{
  namespace
  {
    bool is_driven(const ContactSolution &step, const unsigned int point)
    {
      return step.status[point] == PointStatus::slip && step.state.force[point][1] > 0.;
    }
  } // namespace

  NodePass::NodePass(const OperatingState &steady) : NodePass(steady.contact->n_points())
  {
    const RingContact &contact  = *steady.contact;
    const ContactSolution &step = steady.solution;
    for (unsigned int point = 0; point < contact.n_points(); ++point)
      // A node that never breaks contact gets back to itself.
      for (unsigned int before = contact.earlier(point);
           before != point && step.status[before] != PointStatus::open && !driven[point];
           before = contact.earlier(before))
        driven[point] = is_driven(step, before);
  }

  void NodePass::add(const ContactSolution &step)
  {
    for (unsigned int point = 0; point < driven.size(); ++point)
      driven[point] =
          step.status[point] != PointStatus::open && (driven[point] || is_driven(step, point));
  }

  double NodePass::second_stick_fraction(const ContactSolution &step) const
  {
    AssertDimension(driven.size(), step.status.size());
    double pressed = 0., again = 0.;
    for (unsigned int point = 0; point < driven.size(); ++point)
      if (const double force = step.state.force[point][0]; force > 0.)
      {
        pressed += force;
        again += step.status[point] == PointStatus::stick && driven[point] ? force : 0.;
      }
    return pressed > 0. ? again / pressed : 0.;
  }
} // namespace ringmotor
