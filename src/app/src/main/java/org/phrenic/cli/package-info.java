/** The commands of phrenic, one class each; the only package that prints. */
package org.phrenic.cli;
