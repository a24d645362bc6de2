/** YAML, JSON and CSV documents, with file, line and key in every message. */
package org.phrenic.document;
