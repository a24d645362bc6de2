package org.phrenic;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.io.FileOutputStream;
import java.io.FileWriter;
import java.nio.file.Files;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The walls inside the Maven modules, and what no compiler holds: no cycles, no screen in a headless run. */
class ArchitectureTest {
    static final JavaClasses PROGRAM = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(location -> !location.contains("-tests.jar") && !location.contains("test-classes"))
            // The module of clusters stands above the program and is built by a profile alone.
            .withImportOption(location -> !location.contains("org/phrenic/cluster/"))
            .importPackages("org.phrenic");

    /** Methods of {@link Math} whose last bit the Java machine and the processor decide. */
    private static final Set<String> ROUNDED_BY_THE_MACHINE = Set.of(
            "sin cos tan asin acos atan atan2 sinh cosh tanh exp expm1 log log10 log1p pow cbrt hypot".split(" "));

    private static final Set<String> WRITERS = Set.of("write", "writeString", "newOutputStream", "newBufferedWriter");

    /** What each chapter (the packages that share the name after {@code org.phrenic}) uses, no more and no less. */
    private static final Map<String, List<String>> USES = new LinkedHashMap<>();

    static {
        declare("engine", "");
        declare("file", "");
        declare("mesh", "engine file");
        declare("document", "file");
        declare("parameter", "breathing document file");
        declare("anatomy", "document engine file mesh");
        declare("breathing", "document engine file");
        declare("model", "anatomy breathing document engine file mesh parameter");
        declare("scenario", "anatomy breathing document engine file mesh model parameter");
        declare("simulation", "anatomy breathing document engine file mesh model parameter scenario");
        declare("motion", "anatomy document engine file mesh model simulation");
        declare("patient", "anatomy document engine file mesh");
        declare("fit", "anatomy document engine file mesh model motion parameter patient scenario simulation");
        declare("access", "anatomy breathing document engine file mesh model scenario simulation");
        declare(
                "study",
                "access anatomy breathing document engine file fit"
                        + " mesh model parameter patient scenario simulation");
        declare("scene", "access anatomy breathing document file mesh scenario simulation");
        declare(
                "ui",
                "access anatomy breathing document engine file mesh model"
                        + " parameter patient scenario scene simulation");
        declare(
                "cli",
                "access anatomy breathing document engine file fit mesh model"
                        + " motion parameter patient scenario scene simulation study ui");
    }

    private static void declare(String chapter, String used) {
        USES.put(chapter, used.isEmpty() ? List.of() : List.of(used.split(" ")));
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

    /** Files are written beside their target and moved over it; a journal alone is appended to. */
    @Test
    void onlyAtomicFilesAreWritten() {
        DescribedPredicate<JavaMethodCall> writing = DescribedPredicate.describe(
                "write to a file",
                call -> call.getTargetOwner().isEquivalentTo(Files.class) && WRITERS.contains(call.getName()));
        check(noClasses()
                .that()
                .resideOutsideOfPackage(within("file"))
                .and()
                .doNotHaveSimpleName("FitJournal")
                .should()
                .callMethodWhere(writing)
                .orShould()
                .dependOnClassesThat()
                .belongToAnyOf(FileOutputStream.class, FileWriter.class));
    }

    /** StrictMath gives the same bits on every Java machine; what is only drawn or shown may take Math. */
    @Test
    void resultsTakeStrictMath() {
        DescribedPredicate<JavaAccess<?>> rounding = DescribedPredicate.describe(
                "a method of Math with a last bit of the machine",
                access -> access.getTargetOwner().isEquivalentTo(Math.class)
                        && ROUNDED_BY_THE_MACHINE.contains(access.getName()));
        check(noClasses()
                .that()
                .resideOutsideOfPackages(within("scene"), within("ui"), within("cli.chart"))
                .should()
                .accessTargetWhere(rounding));
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
