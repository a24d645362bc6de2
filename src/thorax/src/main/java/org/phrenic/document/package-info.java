/**
 * CSV, JSON and YAML documents, and binding of YAML to records. Every error message names the file, line and key.
 * Independent of the content of the documents.
 */
package org.phrenic.document;
