package org.phrenic;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The walls inside the Maven modules, and what no compiler holds: no cycles, no screen in a headless run. */
class ArchitectureTest {
    private static final JavaClasses PROGRAM = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(location -> !location.contains("-tests.jar") && !location.contains("test-classes"))
            .importPackages("org.phrenic");

    /** What each chapter (the packages that share the name after {@code org.phrenic}) uses, no more and no less. */
    private static final Map<String, List<String>> USES = new LinkedHashMap<>();

    static {
        USES.put("engine", List.of());
        USES.put("file", List.of());
        USES.put("mesh", List.of("engine", "file"));
        USES.put("document", List.of("file"));
        USES.put("parameter", List.of("breathing", "document", "file"));
        USES.put("anatomy", List.of("document", "engine", "file", "mesh"));
        USES.put("breathing", List.of("document", "engine", "file"));
        USES.put("model", List.of("anatomy", "breathing", "document", "engine", "file", "mesh", "parameter"));
        USES.put("scenario", List.of("anatomy", "breathing", "document", "engine", "file", "model", "parameter"));
        USES.put(
                "simulation",
                List.of(
                        "anatomy",
                        "breathing",
                        "document",
                        "engine",
                        "file",
                        "mesh",
                        "model",
                        "parameter",
                        "scenario"));
        USES.put("patient", List.of("anatomy", "document", "engine", "file", "mesh"));
        USES.put(
                "fit",
                List.of(
                        "anatomy",
                        "document",
                        "engine",
                        "file",
                        "mesh",
                        "model",
                        "parameter",
                        "patient",
                        "scenario",
                        "simulation"));
        USES.put(
                "access",
                List.of(
                        "anatomy",
                        "breathing",
                        "document",
                        "engine",
                        "file",
                        "mesh",
                        "model",
                        "scenario",
                        "simulation"));
        USES.put(
                "study",
                List.of(
                        "access",
                        "anatomy",
                        "breathing",
                        "document",
                        "engine",
                        "file",
                        "fit",
                        "mesh",
                        "model",
                        "parameter",
                        "patient",
                        "scenario",
                        "simulation"));
        USES.put(
                "scene",
                List.of("access", "anatomy", "breathing", "document", "file", "mesh", "scenario", "simulation"));
        USES.put(
                "ui",
                List.of(
                        "access",
                        "anatomy",
                        "breathing",
                        "document",
                        "engine",
                        "file",
                        "mesh",
                        "model",
                        "parameter",
                        "scenario",
                        "scene",
                        "simulation"));
        USES.put(
                "cli",
                List.of(
                        "access",
                        "anatomy",
                        "breathing",
                        "document",
                        "engine",
                        "file",
                        "fit",
                        "mesh",
                        "model",
                        "parameter",
                        "patient",
                        "scenario",
                        "scene",
                        "simulation",
                        "study",
                        "ui"));
    }

    private static String within(String name) {
        return "org.phrenic." + name + "..";
    }

    /** Neither an arrow that is not allowed nor one that is allowed and not used. */
    @Test
    void eachChapterUsesWhatIsDeclared() {
        Map<String, Set<String>> found = new TreeMap<>();
        for (JavaClass from : PROGRAM) {
            Set<String> used = found.computeIfAbsent(chapterOf(from), name -> new TreeSet<>());
            from.getDirectDependenciesFromSelf().stream()
                    .map(dependency -> dependency.getTargetClass().getBaseComponentType())
                    .filter(to -> to.getPackageName().startsWith("org.phrenic"))
                    .map(ArchitectureTest::chapterOf)
                    .filter(name -> !name.equals(chapterOf(from)))
                    .forEach(used::add);
        }
        assertThat(found.keySet()).isEqualTo(USES.keySet());
        Set<String> differences = new TreeSet<>();
        USES.forEach((name, used) -> {
            found.get(name).stream()
                    .filter(other -> !used.contains(other))
                    .forEach(other -> differences.add(name + " uses " + other + ", which is not declared"));
            used.stream()
                    .filter(other -> !found.get(name).contains(other))
                    .forEach(other -> differences.add(name + " is declared to use " + other + ", but does not"));
        });
        assertThat(differences).isEmpty();
    }

    private static String chapterOf(JavaClass type) {
        return type.getPackageName().split("\\.")[2];
    }

    @Test
    void noPackagesUseEachOther() {
        check(slices().matching("org.phrenic.(**)").should().beFreeOfCycles());
    }

    @Test
    void engineKnowsNoFileAndNoScreen() {
        check(noClasses()
                .that()
                .resideInAPackage(within("engine"))
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "java.io..", "java.nio.file..", "java.awt..", "javax..", "org.yaml..", "picocli.."));
    }

    @Test
    void onlyPicturesAndWindowKnowTheScreen() {
        check(noClasses()
                .that()
                .resideOutsideOfPackages(within("scene"), within("ui"), within("cli.chart"))
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
