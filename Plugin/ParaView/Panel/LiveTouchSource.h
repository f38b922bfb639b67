// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchSource_h
#define palpate_LiveTouchSource_h

#include "LiveTouchPlace.h"

#include "vtkSmartPointer.h"

#include <QString>

#include <string>
#include <vector>

class pqOutputPort;
class pqPipelineSource;
class vtkPolyData;

namespace palpate
{
/// A response on a body, known to the client without its data.
struct StoredResponse
{
  std::string name; ///< prefix of its arrays
  std::string tool; ///< its tool, "sphere:6.35"; "" if unknown
};

/// The part of the pipeline that is touched.
struct LiveTouchSource
{
  pqOutputPort* body = nullptr;      ///< null: see obstacle
  pqPipelineSource* touch = nullptr; ///< the source *Touch* whose handle leads the tip, or null
  std::vector<StoredResponse> responses;
  QString obstacle; ///< why nothing can be touched, in words; "": it can
};

/// The body of the active source: its output, or, for a source *Touch*, its input, as its output is
/// dented.
LiveTouchSource findLiveTouchSource(pqOutputPort* active);

/// Its data on the client; waits for the server. With several ranks of the server all parts are
/// joined. Null, and why, if there is none.
vtkSmartPointer<vtkPolyData> fetchBody(pqOutputPort* body, QString& error);

/// The handle of a source *Touch*, also during a drag that is not applied yet.
TouchHandle readTouchHandle(pqPipelineSource* touch);
} // namespace palpate

#endif
