package org.phrenic;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Files of all modules that people write: what a build makes beside them may vanish while it is listed. */
final class SourceTree {
    private SourceTree() {}

    /**
     * Sources, resources and build file of every module, of production and of tests. What has no build file is no
     * module: a folder of an editor, or what a build has left of a module of another branch.
     */
    static List<Path> files() throws IOException {
        List<Path> all = new ArrayList<>();
        try (Stream<Path> modules = Files.list(Path.of("src"))) {
            for (Path module : modules.sorted().toList()) {
                Path build = module.resolve("pom.xml");
                if (!Files.isRegularFile(build)) {
                    continue;
                }
                all.add(build);
                try (Stream<Path> files = Files.walk(module.resolve("src"))) {
                    files.filter(Files::isRegularFile).forEach(all::add);
                }
            }
        }
        return all;
    }
}
