/**
 * The import of a body from end to end: request, pipeline, result, report and thorax folder. The command line, the
 * window and the studies run the same {@link org.phrenic.patient.pipeline.ImportPipeline}.
 */
package org.phrenic.patient.pipeline;
