/* Copyright (c) 2026 The Inter_angle_remeshing authors.
   SPDX-License-Identifier: GPL-3.0-or-later

   The mathematical functions as another library, or another processor, might round them: of every four results one is a unit in the last
   place larger, and one smaller, which ones the environment variable MATH_SEED decides. To be loaded before a program's own
   libraries, see scripts/test_rounding.sh. What every library gives exactly stays: zero, one, and multiples of 45 degrees. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static uint64_t bits(double x)
{
  uint64_t result;
  memcpy(&result, &x, sizeof result);
  return result;
}

static uint64_t seed(void)
{
  const char* text = getenv("MATH_SEED");
  return text ? strtoull(text, NULL, 10) : 0;
}

static double perturbed(double result, double x, double y)
{
  static uint64_t run;
  uint64_t hash;
  if(run == 0)
    run = 2 * seed() + 1;
  if(!isfinite(result) || result == 0 || fabs(result) == 1 || fmod(fabs(result), M_PI_4) == 0)
    return result;
  hash = bits(x) ^ (bits(y) * 0x9E3779B97F4A7C15u) ^ (run * 0xD1B54A32D192ED03u);
  hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9u;
  hash = (hash ^ (hash >> 27)) * 0x94D049BB133111EBu;
  switch((hash >> 40) & 3)
  {
    case 0: return nextafter(result, INFINITY);
    case 1: return nextafter(result, -INFINITY);
    default: return result;
  }
}

#define PERTURBED_OF_ONE(name)                                                                       \
  double name(double x)                                                                              \
  {                                                                                                  \
    static double (*original)(double);                                                               \
    if(!original)                                                                                    \
      *(void**)&original = dlsym(RTLD_NEXT, #name);                                                  \
    return perturbed(original(x), x, 0);                                                             \
  }

#define PERTURBED_OF_TWO(name)                                                                       \
  double name(double x, double y)                                                                    \
  {                                                                                                  \
    static double (*original)(double, double);                                                       \
    if(!original)                                                                                    \
      *(void**)&original = dlsym(RTLD_NEXT, #name);                                                  \
    return perturbed(original(x, y), x, y);                                                          \
  }

PERTURBED_OF_ONE(sin)
PERTURBED_OF_ONE(cos)
PERTURBED_OF_ONE(tan)
PERTURBED_OF_ONE(asin)
PERTURBED_OF_ONE(acos)
PERTURBED_OF_ONE(atan)
PERTURBED_OF_ONE(exp)
PERTURBED_OF_ONE(log)
PERTURBED_OF_ONE(cbrt)
PERTURBED_OF_TWO(atan2)
PERTURBED_OF_TWO(pow)
PERTURBED_OF_TWO(hypot)

void sincos(double x, double* sine, double* cosine)
{
  *sine = sin(x);
  *cosine = cos(x);
}
