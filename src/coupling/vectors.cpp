#include "coupling/vectors.hpp"

#include <nvector/nvector_serial.h>

#include <cmath>
#include <cstddef>

#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

std::size_t length(N_Vector v) { return static_cast<std::size_t>(NV_LENGTH_S(v)); }

// z_i = value(i). z may be what `value` reads.
template <class Value>
void set(N_Vector z, const Value& value) {
  double* const out = NV_DATA_S(z);
  parallel_for(length(z), [&](std::size_t i) { out[i] = value(i); });
}

void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
  const double *u = NV_DATA_S(x), *v = NV_DATA_S(y);
  set(z, [&](std::size_t i) { return a * u[i] + b * v[i]; });
}

void fill(realtype c, N_Vector z) {
  set(z, [&](std::size_t) { return c; });
}

void scale(realtype c, N_Vector x, N_Vector z) {
  const double* u = NV_DATA_S(x);
  set(z, [&](std::size_t i) { return c * u[i]; });
}

void multiply(N_Vector x, N_Vector y, N_Vector z) {
  const double *u = NV_DATA_S(x), *v = NV_DATA_S(y);
  set(z, [&](std::size_t i) { return u[i] * v[i]; });
}

void quotient(N_Vector x, N_Vector y, N_Vector z) {
  const double *u = NV_DATA_S(x), *v = NV_DATA_S(y);
  set(z, [&](std::size_t i) { return u[i] / v[i]; });
}

realtype dot(N_Vector x, N_Vector y) {
  const double *u = NV_DATA_S(x), *v = NV_DATA_S(y);
  return parallel_sum(length(x), [&](std::size_t i) { return u[i] * v[i]; });
}

realtype weighted_rms(N_Vector x, N_Vector w) {
  const double *u = NV_DATA_S(x), *v = NV_DATA_S(w);
  const double sum = parallel_sum(length(x), [&](std::size_t i) {
    const double weighted = u[i] * v[i];
    return weighted * weighted;
  });
  return std::sqrt(sum / static_cast<double>(length(x)));
}

}  // namespace

N_Vector make_vector(std::vector<double>& data, SUNContext context) {
  N_Vector v = N_VMake_Serial(static_cast<sunindextype>(data.size()), data.data(), context);
  v->ops->nvlinearsum = linear_sum;
  v->ops->nvconst = fill;
  v->ops->nvscale = scale;
  v->ops->nvprod = multiply;
  v->ops->nvdiv = quotient;
  v->ops->nvdotprod = dot;
  v->ops->nvwrmsnorm = weighted_rms;
  return v;
}

}  // namespace pmr::coupling
