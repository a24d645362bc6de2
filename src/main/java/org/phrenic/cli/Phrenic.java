package org.phrenic.cli;

import picocli.CommandLine;
import picocli.CommandLine.Command;

/** The {@code phrenic} command. */
@Command(name = "phrenic", mixinStandardHelpOptions = true)
public final class Phrenic implements Runnable {
    @Override
    public void run() {}

    public static void main(String[] args) {
        System.exit(new CommandLine(new Phrenic()).execute(args));
    }
}
