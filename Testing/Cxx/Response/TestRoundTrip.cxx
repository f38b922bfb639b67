// SPDX-License-Identifier: BSD-3-Clause
// A body with a response, saved as .vtp and read back, gives the same bits. The last argument is
// the folder to write to.
//
// The data are inline, base64 and compressed. Appended data, VTK's default, are not tested: VTK
// before 9.3.1 with an expat that defers parsing (2.6.0, or Debian 12's 2.5.0-1+deb12u5) fails to
// read about half of such files, depending on the position of "<AppendedData" (VTK issue 19258).
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkToolContactProbe.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdio>
#include <cstring>

namespace
{
using namespace palpate::testing;

Body makeBody()
{
  Body body = sphereBody(15.0, 3);
  pointArray(body, "E", [](vtkIdType i) { return 0.1 + 0.01 * static_cast<double>(i % 31); });
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool("sphere:3.1"));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  Body output = Body::New();
  output->DeepCopy(filter->GetOutput());
  return output;
}

/// The same body in compact form: one law and a coefficient per point.
Body makeCompact(vtkPolyData* full)
{
  Body body = Body::New();
  body->DeepCopy(full);
  vtkPointData* points = body->GetPointData();
  vtkNew<vtkFloatArray> basis;
  basis->SetName("ResponseBasis");
  basis->SetNumberOfComponents(16);
  for (const char* name : { "ResponseForce", "ResponseStiffness" })
  {
    for (int k = 0; k < 8; ++k)
    {
      basis->InsertNextValue(static_cast<float>(points->GetArray(name)->GetComponent(0, k)));
    }
  }
  body->GetFieldData()->AddArray(basis);
  vtkDataArray* young = points->GetArray("E");
  pointArray<vtkFloatArray>(body, "ResponseCoefficient",
    [young](vtkIdType i) { return young->GetTuple1(i) / young->GetTuple1(0); });
  points->RemoveArray("ResponseForce");
  points->RemoveArray("ResponseStiffness");
  return body;
}

bool sameBits(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues()) *
        static_cast<std::size_t>(a->GetDataTypeSize())) == 0;
}

void checkRoundTrip(vtkPolyData* body, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(body);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  PALPATE_CHECK(writer->Write() == 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();

  vtkPointData* points = body->GetPointData();
  PALPATE_CHECK(read->GetPointData()->GetNumberOfArrays() == points->GetNumberOfArrays());
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    PALPATE_CHECK(
      sameBits(points->GetArray(i), read->GetPointData()->GetArray(points->GetArrayName(i))));
  }
  vtkFieldData* field = body->GetFieldData();
  for (int i = 0; i < field->GetNumberOfArrays(); ++i)
  {
    const char* name = field->GetArrayName(i);
    auto* text = vtkStringArray::SafeDownCast(field->GetAbstractArray(i));
    auto* same = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray(name));
    PALPATE_CHECK(text ? same && same->GetValue(0) == text->GetValue(0)
                       : sameBits(field->GetArray(i), read->GetFieldData()->GetArray(name)));
  }

  const Body tips = tipsInCube(500, 15.0, 99);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetTipData(tips);
  probe->SetInputData(body);
  probe->Update();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(probe->GetOutput());
  probe->SetInputData(read);
  probe->Update();
  int contacts = 0;
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    contacts += before->GetPointData()->GetArray("NormalForce")->GetTuple1(i) > 0.0;
  }
  PALPATE_CHECK(contacts > 50);
  for (const char* name : { "Force", "Normal", "ContactPoint", "ContactCell", "ContactState" })
  {
    PALPATE_CHECK(sameBits(
      before->GetPointData()->GetArray(name), probe->GetOutput()->GetPointData()->GetArray(name)));
  }
  std::remove(file.c_str());
}
} // namespace

int TestRoundTrip(int argc, char* argv[])
{
  const std::string folder = argv[argc - 1];
  const Body body = makeBody();
  checkRoundTrip(body, folder + "/palpate_round_trip.vtp");
  checkRoundTrip(makeCompact(body), folder + "/palpate_round_trip_compact.vtp");
  return palpate::testing::result();
}
