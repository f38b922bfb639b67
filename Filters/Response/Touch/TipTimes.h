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
 * times if neither input has any. Called by RequestInformation.
 */
void passTimes(vtkInformationVector** inputs, vtkInformation* output);

/// Sets DATA_TIME_STEP of the output to that of the tips or, if the tips have none, to that of the
/// body. `body` and `tips` may be null.
void passDataTime(vtkDataObject* body, vtkDataObject* tips, vtkDataObject* output);
} // namespace palpate

#endif
