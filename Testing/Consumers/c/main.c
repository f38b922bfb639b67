/* SPDX-License-Identifier: BSD-3-Clause */
/* A plain C program: load a body, step, reset. */
#include <palpate.h>

#include <math.h>
#include <stdio.h>

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
  palpate_body_free(body);
  /* The exact sphere of 6.35 mm at 0.5 mm and E* = 3.45 MPa: 4.06596 N; the mesh sags a little. */
  return fabs(force - 4.06596) < 0.03 ? 0 : 1;
}
