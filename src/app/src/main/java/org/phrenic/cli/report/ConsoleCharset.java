package org.phrenic.cli.report;

import java.io.Console;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;

/** The charset of what is printed: UTF-8 in files, pipes and terminals, but that of its own in a console of Windows. */
public final class ConsoleCharset {
    private ConsoleCharset() {}

    /** The charset for the output of this process. */
    @SuppressWarnings("SystemConsoleNull") // null if the output is not shown; with Java 22 to 24 never
    public static Charset ofProcess() {
        return of(
                System.getProperty("os.name", ""),
                Optional.ofNullable(System.console()).map(Console::charset));
    }

    /**
     * The charset for a system.
     *
     * @param system name of the operating system
     * @param console charset of the console; empty if the output goes elsewhere
     */
    static Charset of(String system, Optional<Charset> console) {
        boolean windows = system.toLowerCase(Locale.ROOT).startsWith("windows");
        return console.filter(own -> windows).orElse(StandardCharsets.UTF_8);
    }
}
