/* SPDX-License-Identifier: BSD-3-Clause */
/* A plain C program: load a body, step, reset; and slide with friction. */
#include <palpate.h>

#include <math.h>
#include <stdio.h>

/* Slides 2 mm along the cylinder, 0.5 mm deep, with a friction of 0.5. */
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
  /* Coulomb's limit, against the motion: what is elastic, 2 N / 10 N/mm, was passed long ago. */
  return tick.state == PALPATE_SLIDE &&
    fabs(tick.friction[0] + 0.5 * tick.normal_force) < 1e-3 * tick.normal_force;
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
  if (!slide(body))
  {
    return 1;
  }
  palpate_body_free(body);
  /* The exact sphere of 6.35 mm at 0.5 mm and E* = 3.45 MPa: 4.06596 N; the mesh sags a little. */
  return fabs(force - 4.06596) < 0.03 ? 0 : 1;
}
