/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * A plain C program: load a body, step, reset; slide with friction; press with mapping and safety,
 * and change to another scene.
 */
#include <palpate.h>

#include <math.h>
#include <stdio.h>

/* Slides 2 mm along the cylinder at a depth of 0.5 mm with a friction coefficient of 0.5. */
static int slide(const palpate_body* body)
{
  char reason[256];
  int i;
  palpate_tick tick;
  palpate_contact* contact;
  palpate_settings settings;
  palpate_settings_default(&settings);
  settings.friction_coefficient = -0.5;
  if (palpate_contact_new_with(body, 20.0, &settings, reason, sizeof reason))
  {
    return 0;
  }
  printf("refused: %s\n", reason);
  settings.friction_coefficient = 0.5;
  settings.tangential_stiffness = 10.0;
  contact = palpate_contact_new_with(body, 20.0, &settings, reason, sizeof reason);
  if (!contact)
  {
    fprintf(stderr, "%s\n", reason);
    return 0;
  }
  for (i = 0; i <= 100; ++i)
  {
    const double position[3] = { 2e-5 * i, 0.0, 0.0495 };
    palpate_step(contact, position, 0.001 * i, &tick);
  }
  palpate_contact_free(contact);
  printf("normal force %.4g N, friction %.4g N\n", tick.normal_force, tick.friction[0]);
  /*
   * Coulomb's limit, against the motion. The elastic displacement, 2 N / 10 N/mm, was exceeded long
   * before.
   */
  return tick.state == PALPATE_SLIDE &&
    fabs(tick.friction[0] + 0.5 * tick.normal_force) < 1e-3 * tick.normal_force;
}

/*
 * Moves from 1 mm above the cylinder to a depth of 0.4 mm and rests there. Then changes to another
 * scene with half the force.
 */
static int exchange(const palpate_body* body)
{
  char reason[256];
  int i;
  double before;
  palpate_mapping mapping;
  palpate_safety safety;
  palpate_sample sample;
  palpate_full_tick tick;
  palpate_contact* contact;
  palpate_mapping_default(&mapping);
  palpate_safety_of(NULL, &safety);
  safety.maximum_stiffness = 1e5; /* N/m: nothing is to be capped here */
  mapping.translation[2] = 50.0;  /* the top of the cylinder is at the device's middle */
  contact = palpate_contact_new_safe(body, &mapping, &safety, NULL, 0, reason, sizeof reason);
  if (!contact)
  {
    fprintf(stderr, "%s\n", reason);
    return 0;
  }
  palpate_sample_default(&sample);
  for (i = 0; i <= 200; ++i)
  {
    sample.position[2] = i < 140 ? 1e-3 - 1e-5 * i : -4e-4;
    palpate_step_sample(contact, &sample, 0.001 * i, &tick);
  }
  before = tick.tick.device_force[2];
  palpate_change(contact, palpate_scene_new(body, NULL, 0.5, reason, sizeof reason));
  for (; i <= 260; ++i)
  {
    const double last = tick.tick.device_force[2];
    palpate_step_sample(contact, &sample, 0.001 * i, &tick);
    if (fabs(tick.tick.device_force[2] - last) > 0.011 * before) /* half of it in 50 ticks */
    {
      return 0;
    }
  }
  printf("%.4g N, and with half the force factor %.4g N\n", before, tick.tick.device_force[2]);
  palpate_scene_free(palpate_take_retired(contact));
  palpate_contact_free(contact);
  return before > 1.0 && tick.scene == 1 && fabs(tick.tick.device_force[2] - 0.5 * before) < 1e-9;
}

int main(int argc, char** argv)
{
  char reason[256];
  const double above[3] = { 0.0, 0.0, 0.052 };
  const double pressed[3] = { 0.0, 0.0, 0.0495 };
  palpate_tick tick;
  double force;
  palpate_body* body = palpate_body_load(argc > 1 ? argv[1] : "", reason, sizeof reason);
  palpate_contact* contact = palpate_contact_new(body, 20.0);
  if (!contact)
  {
    fprintf(stderr, "%s\n", reason);
    return 1;
  }
  palpate_step(contact, above, 0.000, &tick);
  if (tick.state != PALPATE_NONE || tick.triangle != -1)
  {
    return 1;
  }
  palpate_step(contact, pressed, 0.001, &tick);
  force = tick.device_force[2];
  printf("deflection %.4g mm, force %.4g N\n", tick.deflection, force);
  palpate_reset(contact);
  palpate_step(contact, above, 0.002, &tick);
  if (tick.device_force[2] != 0.0)
  {
    return 1;
  }
  palpate_contact_free(contact);
  if (!slide(body) || !exchange(body))
  {
    return 1;
  }
  palpate_body_free(body);
  /*
   * The exact sphere of 6.35 mm at 0.5 mm and E* = 3.45 MPa: 4.06596 N. The mesh is slightly below
   * the true surface.
   */
  return fabs(force - 4.06596) < 0.03 ? 0 : 1;
}
