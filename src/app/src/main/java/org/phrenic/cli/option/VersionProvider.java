package org.phrenic.cli.option;

import org.phrenic.document.report.Disclaimer;
import picocli.CommandLine.IVersionProvider;

/** Provides the version from the jar manifest. */
public final class VersionProvider implements IVersionProvider {
    @Override
    public String[] getVersion() {
        String version = VersionProvider.class.getPackage().getImplementationVersion();
        return new String[] {
            "phrenic " + (version == null ? "(not packaged)" : version) + ", Java " + Runtime.version(), Disclaimer.TEXT
        };
    }
}
