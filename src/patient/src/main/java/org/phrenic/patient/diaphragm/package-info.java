/**
 * The diaphragm built from the organs and bones of a body: the inner envelope of the rib cage
 * ({@link org.phrenic.patient.diaphragm.CageEnvelope}), the dome between thoracic and abdominal organs
 * ({@link org.phrenic.patient.diaphragm.DomeSurface}), the line of insertion
 * ({@link org.phrenic.patient.diaphragm.InsertionLine}), the sheet of both
 * ({@link org.phrenic.patient.diaphragm.DiaphragmBuilder}) and the measures of its quality
 * ({@link org.phrenic.patient.diaphragm.SheetQuality}).
 */
package org.phrenic.patient.diaphragm;
