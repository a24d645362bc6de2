package org.phrenic;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import java.io.IOException;
import java.lang.module.Configuration;
import java.lang.module.ModuleFinder;
import java.lang.module.ModuleReference;
import java.lang.module.ResolvedModule;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What a user of the image with its own Java, or of an installer, relies on. */
class DistributionTest {
    private static final Path BUILD = Path.of("src/app/pom.xml");
    private static final Pattern MODULES = Pattern.compile("<addModule>(.*?)</addModule>");

    /** Modules of Java in the image: those listed and those that they need. */
    private static Set<String> modulesOfTheImage() throws IOException {
        List<String> listed = MODULES.matcher(Files.readString(BUILD))
                .results()
                .flatMap(found -> Stream.of(found.group(1).split(",")))
                .toList();
        return Configuration.empty().resolve(ModuleFinder.ofSystem(), ModuleFinder.of(), listed).modules().stream()
                .map(ResolvedModule::name)
                .collect(Collectors.toSet());
    }

    /** Else a command that works from the jar ends in the image with a class that is not found. */
    @Test
    void theImageHasTheModulesOfAllClassesThatTheProgramUses() throws IOException {
        Map<String, String> moduleOfPackage = new HashMap<>();
        for (ModuleReference module : ModuleFinder.ofSystem().findAll()) {
            module.descriptor()
                    .packages()
                    .forEach(name ->
                            moduleOfPackage.put(name, module.descriptor().name()));
        }
        Set<String> used = new TreeSet<>();
        for (JavaClass from : ArchitectureTest.PROGRAM) {
            from.getDirectDependenciesFromSelf().stream()
                    .map(to -> moduleOfPackage.get(
                            to.getTargetClass().getBaseComponentType().getPackageName()))
                    .filter(module -> module != null)
                    .forEach(used::add);
        }

        assertThat(used).contains("java.base", "java.desktop").isSubsetOf(modulesOfTheImage());
    }

    /** Character sets of DICOM that the program names by text, which no class names. */
    @Test
    void theImageHasTheCharacterSetsOfEastAsia() throws IOException {
        assertThat(modulesOfTheImage()).contains("jdk.charsets");
    }

    /** Screen readers reach the window on Windows by the Java Access Bridge, which no class of the program names. */
    @Test
    void theImageHasTheAccessBridge() throws IOException {
        assertThat(modulesOfTheImage()).contains("jdk.accessibility");
    }
}
