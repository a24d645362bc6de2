/**
 * CSV, JSON and YAML documents and the binding of YAML to records, with file, line and key in every message. Knows
 * nothing of what the values mean.
 */
package org.phrenic.document;
