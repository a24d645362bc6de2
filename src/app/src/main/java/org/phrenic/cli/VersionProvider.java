package org.phrenic.cli;

import org.phrenic.document.report.Disclaimer;
import picocli.CommandLine.IVersionProvider;

/** Provides the version from the jar manifest. */
final class VersionProvider implements IVersionProvider {
    @Override
    public String[] getVersion() {
        String version = Phrenic.class.getPackage().getImplementationVersion();
        return new String[] {
            "phrenic " + (version == null ? "(not packaged)" : version) + ", Java " + Runtime.version(), Disclaimer.TEXT
        };
    }
}
