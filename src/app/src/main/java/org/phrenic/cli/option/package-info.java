/** Options that several commands share. */
package org.phrenic.cli.option;
