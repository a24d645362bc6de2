package org.phrenic.file;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Arrays;
import java.util.Enumeration;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Identifies the code that computes: the program's jars by the checksums of their entries, the libraries by name. */
final class BuildIdentity {
    /** Jars of the program whose code or data decides how a body and its scene are computed. */
    private static final String[] COMPUTING = {"phrenic-engine-", "phrenic-mesh-", "phrenic-thorax-"};

    private static final long ODD = 0x9E37_79B9_7F4A_7C15L;

    private BuildIdentity() {}

    /**
     * The identity of the running program and its Java; empty if its classes do not come from one folder of jars, as in
     * a development environment.
     */
    static Optional<String> ofProgram() {
        CodeSource source = BuildIdentity.class.getProtectionDomain().getCodeSource();
        if (source == null) {
            return Optional.empty();
        }
        try {
            Path jar = Path.of(source.getLocation().toURI());
            return jar.getFileName().toString().endsWith(".jar") ? ofFolder(jar.getParent()) : Optional.empty();
        } catch (URISyntaxException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** The identity of the jars in a folder; empty if one of the program's is missing. */
    static Optional<String> ofFolder(Path folder) {
        String[] names = folder.toFile().list((parent, name) -> name.endsWith(".jar"));
        if (names == null) {
            return Optional.empty();
        }
        Arrays.sort(names);
        StringBuilder text = new StringBuilder()
                .append(System.getProperty("java.vm.version"))
                .append(' ')
                .append(System.getProperty("os.arch"));
        int found = 0;
        try {
            for (String name : names) {
                boolean computing = Arrays.stream(COMPUTING).anyMatch(name::startsWith);
                if (computing) {
                    found++;
                    text.append(' ')
                            .append(Long.toHexString(
                                    checksum(folder.resolve(name).toFile())));
                } else if (!name.startsWith("phrenic-")) {
                    text.append(' ').append(name);
                }
            }
        } catch (IOException e) {
            return Optional.empty();
        }
        return found == COMPUTING.length ? Optional.of(text.toString()) : Optional.empty();
    }

    private static long checksum(File jar) throws IOException {
        long sum = jar.length();
        try (ZipFile zip = new ZipFile(jar)) {
            for (Enumeration<? extends ZipEntry> entries = zip.entries(); entries.hasMoreElements(); ) {
                ZipEntry entry = entries.nextElement();
                sum = (sum ^ entry.getCrc() ^ entry.getName().hashCode()) * ODD;
                sum ^= sum >>> 29;
            }
        }
        return sum;
    }
}
