// SPDX-License-Identifier: BSD-3-Clause
#ifndef TipTimes_h
#define TipTimes_h

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace palpate
{
/**
 * Sets the times of a filter with two inputs, body and tips. TIME_STEPS of the output are the steps
 * of both inputs, without repetition, in ascending order. TIME_RANGE covers both inputs. Sets no
 * times if neither input has time steps. RequestInformation calls this function.
 */
void passTimes(vtkInformationVector** inputs, vtkInformation* output);

/// Sets DATA_TIME_STEP of the output to the value of the tips. If the tips have no value, the value
/// of the body is used. `body` and `tips` may be null.
void passDataTime(vtkDataObject* body, vtkDataObject* tips, vtkDataObject* output);
} // namespace palpate

#endif
