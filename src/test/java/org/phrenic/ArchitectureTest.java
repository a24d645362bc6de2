package org.phrenic;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The floors of the house: a lower one never uses a higher one. */
class ArchitectureTest {
    private static final JavaClasses PROGRAM = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("org.phrenic");

    /** What each package may use besides itself, Java and libraries. */
    private static final Map<String, List<String>> MAY_USE = new LinkedHashMap<>();

    static {
        MAY_USE.put("geometry", List.of());
        MAY_USE.put("engine", List.of("geometry"));
        MAY_USE.put("format", List.of("geometry", "engine"));
        MAY_USE.put("anatomy", List.of("geometry", "engine", "format"));
        MAY_USE.put("breathing", List.of("geometry", "engine", "format"));
        MAY_USE.put("simulation", List.of("geometry", "engine", "format", "anatomy", "breathing"));
        MAY_USE.put("rehearsal", List.of("geometry", "engine", "format", "anatomy", "breathing", "simulation"));
        MAY_USE.put("patient", List.of("geometry", "engine", "format", "anatomy"));
        List<String> upToRehearsal =
                List.of("geometry", "engine", "format", "anatomy", "breathing", "simulation", "rehearsal", "patient");
        MAY_USE.put("study", upToRehearsal);
        MAY_USE.put("scene", upToRehearsal);
        MAY_USE.put("ui", and(upToRehearsal, "study", "scene"));
        MAY_USE.put("cli", and(upToRehearsal, "study", "scene", "ui"));
    }

    private static List<String> and(List<String> some, String... more) {
        return Stream.concat(some.stream(), Stream.of(more)).toList();
    }

    private static String within(String name) {
        return "org.phrenic." + name + "..";
    }

    @Test
    void everyPackageHasAFloor() {
        assertThat(PROGRAM.stream()
                        .map(JavaClass::getPackageName)
                        .filter(name -> name.startsWith("org.phrenic."))
                        .map(name -> name.split("\\.")[2]))
                .isSubsetOf(MAY_USE.keySet());
    }

    @Test
    void aFloorUsesOnlyTheFloorsBelow() {
        MAY_USE.forEach((name, below) -> {
            String[] allowed = Stream.concat(Stream.of(name), below.stream())
                    .map(ArchitectureTest::within)
                    .toArray(String[]::new);
            DescribedPredicate<JavaClass> outside = DescribedPredicate.describe(
                    "org.phrenic outside " + Arrays.toString(allowed),
                    used -> used.getPackageName().startsWith("org.phrenic")
                            && !JavaClass.Predicates.resideInAnyPackage(allowed).test(used));
            check(noClasses().that().resideInAPackage(within(name)).should().dependOnClassesThat(outside));
        });
    }

    @Test
    void noPackagesUseEachOther() {
        check(slices().matching("org.phrenic.(**)").should().beFreeOfCycles());
    }

    @Test
    void geometryAndEngineKnowNoFileAndNoScreen() {
        check(noClasses()
                .that()
                .resideInAnyPackage(within("geometry"), within("engine"))
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "java.io..", "java.nio.file..", "java.awt..", "javax..", "org.yaml..", "picocli.."));
    }

    @Test
    void onlySceneAndWindowKnowTheScreen() {
        check(noClasses()
                .that()
                .resideOutsideOfPackages(within("scene"), within("ui"))
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("java.awt..", "javax.swing..", "com.jogamp.."));
    }

    @Test
    void onlyTheCommandLinePrints() {
        check(noClasses()
                .that()
                .resideOutsideOfPackage(within("cli"))
                .should()
                .accessField(System.class, "out")
                .orShould()
                .accessField(System.class, "err")
                .orShould()
                .callMethod(Throwable.class, "printStackTrace"));
    }

    @Test
    void onlyTheCommandLineEndsTheProcessAndKnowsItsParser() {
        check(noClasses()
                .that()
                .resideOutsideOfPackage(within("cli"))
                .should()
                .callMethod(System.class, "exit", int.class)
                .orShould()
                .dependOnClassesThat()
                .resideInAPackage("picocli.."));
    }

    @Test
    void nothingStaticChanges() {
        check(fields().that().areStatic().should().beFinal());
    }

    @Test
    void exceptionsOfAllKindsAreNamedSo() {
        check(classes().that().areAssignableTo(Throwable.class).should().haveSimpleNameEndingWith("Exception"));
    }

    private static void check(ArchRule rule) {
        rule.allowEmptyShould(true).check(PROGRAM);
    }
}
