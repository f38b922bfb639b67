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
/// A response on a body, as the client knows it without its data.
struct StoredResponse
{
  std::string name; ///< prefix of its arrays
  std::string tool; ///< what it is the response of, "sphere:6.35"; "" where nobody says
};

/// What of the pipeline is to be touched.
struct LiveTouchSource
{
  pqOutputPort* body = nullptr;      ///< null: see obstacle
  pqPipelineSource* touch = nullptr; ///< the source *Touch* whose handle leads the tip, or null
  std::vector<StoredResponse> responses;
  QString obstacle; ///< why nothing can be touched, in words; "": it can
};

/// What the active source stands for: the body it puts out, or, of a source *Touch*, the body it
/// takes in, since what it puts out is dented.
LiveTouchSource findLiveTouchSource(pqOutputPort* active);

/// Its data on the client; the server is waited for. With several servers' ranks all parts in one.
/// Null, and why, if there is none.
vtkSmartPointer<vtkPolyData> fetchBody(pqOutputPort* body, QString& error);

/// The handle of a source *Touch*, also while it is dragged and nothing is applied yet.
TouchHandle readTouchHandle(pqPipelineSource* touch);
} // namespace palpate

#endif
