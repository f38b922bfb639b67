// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/WindowPicture.h"

#include "Mechanics/Files/WholeFile.h"

#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

namespace palpate
{
std::string writeWindowPicture(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer; // the picture is first written to memory, because vtkPNGWriter does
                               // not report a full disk
  writer->SetInputConnection(grab->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* picture = writer->GetResult();
  if (writer->GetErrorCode() != 0 || !picture)
  {
    return "cannot make the picture '" + file + "'";
  }
  WholeFile whole(file);
  std::string error = whole.open();
  if (error.empty())
  {
    whole.write(picture->GetPointer(0), static_cast<std::size_t>(picture->GetNumberOfValues()));
    error = whole.finish();
  }
  return error;
}
} // namespace palpate
