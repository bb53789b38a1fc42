{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Source.MessageSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.List (nub, sort)
import qualified Data.Text as Text
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Message
import Laws.Reading
import Test.Hspec hiding (Expectation)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (conjoin, counterexample)

spec :: Spec
spec = do
  describe "each problem" $ do
    prop "is said in both languages" . conjoin $ map (\p -> counterexample (show p) (isSaidInBothLanguages p)) problems
    prop "has a code for programs" . conjoin $ map hasAStableCode problems
    it "has the code that it always had" $
      nub (sort (map code problems))
        `shouldBe` sort
          ( ["unknown-word", "misplaced-word", "stray-end", "misspelt-end", "missing-end", "unclosed-comment", "behind-opening", "repeated-property", "second-shape", "decimal-comma"]
              <> ["no-material-name", "missing-material", "repeated-material", "replaced-object", "sampling-without-random"]
              <> ["no-model-file", "unknown-model-format", "empty-model", "model-cycle", "model-too-deep", "too-many-parts", "differing-uv-format"]
              <> ["missing-rows", "unequal-rows", "pieces-without-length"]
              <> ["bad-face", "mixed-face", "short-face", "missing-vertex", "missing-attribute", "no-attributes", "collinear-triangles", "long-line", "too-many-libraries", "unknown-material-of-model", "more-faults"]
              <> ["missing-file", "several-files", "unreadable-file"]
              <> ["missing-value", "not-a-number", "not-an-integer", "number-too-large", "out-of-range", "wrong-count", "unknown-choice", "unsafe-name", "name-taken", "wrong-ending", "zero-vector", "zero-component", "same-point"]
              <> ["no-shape", "zero-size", "zero-normal", "nowhere-to-look", "up-along-front", "far-before-near", "collinear-points", "equal-points", "inner-beyond-outer"]
              <> ["curvature-below-radius", "lens-too-thin", "zero-orientation", "no-attenuation", "invisible-wavelength", "too-many-pixels", "too-many-oscillators"]
          )
    it "names what it is about" $
      for_ [English, French] $ \l -> do
        message l (UnknownWord "sphre" [] (Just "sphere") TheLine) `shouldSatisfy` (\t -> all (`Text.isInfixOf` t) ["'sphre'", "'sphere'"])
        message l (RefusedValue "ray" (OutOfRange "-1") AVector (Kept "2.0")) `shouldSatisfy` (\t -> all (`Text.isInfixOf` t) ["'-1'", "'ray'"])
        message l (MissingEnd "camera" (Just ("viewport", 12))) `shouldSatisfy` (\t -> all (`Text.isInfixOf` t) ["'camera'", "'viewport'", "12"])
        used l (UnknownWord "sphre" [] Nothing (TheObject 15)) `shouldSatisfy` maybe False ("15" `Text.isInfixOf`)
        used l (RefusedValue "ray" (OutOfRange "-1") AVector (Kept "2.0")) `shouldBe` Just "2.0"
        expected l (RefusedValue "ray" (OutOfRange "-1") (ARealNumber (Between "10.0" "170.0")) (Kept "2.0")) `shouldSatisfy` maybe False (\t -> all (`Text.isInfixOf` t) ["10.0", "170.0"])
    it "has folders that a person can name" $
      [message l (UnusableFile "a.png" ForTexture (NoSuchFile [".", "scenes", "models", "./..."] g)) | g <- [Nothing, Just "b.png"], l <- [English, French]]
        `shouldBe` [ "no file is called 'a.png' in the working directory, scenes, models, any folder below",
                     "aucun fichier ne s'appelle 'a.png', ni dans le répertoire courant, ni dans scenes, ni dans models, ni dans un dossier plus bas",
                     "no file is called 'a.png' in the working directory, scenes, models, any folder below; did you mean 'b.png'?",
                     "aucun fichier ne s'appelle 'a.png', ni dans le répertoire courant, ni dans scenes, ni dans models, ni dans un dossier plus bas\xA0; vouliez-vous dire 'b.png'\xA0?"
                   ]
    it "says what becomes of an object, whatever its gender" $
      [used l (ImpossibleObject "camera" NowhereToLook f) | l <- [English, French], f <- [LeftOut, Superseded]]
        `shouldBe` map Just ["nothing: it is left out", "the one before it, or the default", "rien\xA0: cet objet est omis", "l'objet d'avant, ou celui par défaut"]
    it "says of a text that it is no picture" $
      [message l (UnusableFile "s1.txt" ForTexture (Undecodable NoPicture)) | l <- [English, French]]
        `shouldBe` ["'s1.txt': this is no png, jpg, gif, bmp or tga picture", "'s1.txt'\xA0: ce n'est pas une image png, jpg, gif, bmp ou tga"]
    it "is cut short where the file is long-winded" $
      for_ [English, French] $ \l ->
        message l (UnknownWord (Text.replicate 10000 "x") [] Nothing TheLine) `shouldSatisfy` ((< 200) . Text.length)
  describe "what is expected" $
    it "is said in both languages, which are not the same" $
      for_ expectations $ \e -> do
        map (\l -> Text.null (expectation l e)) [English, French] `shouldBe` [False, False]
        expectation English e `shouldNotBe` expectation French e
  it "is one of several words, and all formats of pictures, in either language" $ do
    [expected l (UnknownWord "x" ["a", "b"] Nothing TheLine) | l <- [English, French]] `shouldBe` [Just "one of a, b", Just "l'un de a, b"]
    [expected l (UnusableFile "x" ForTexture (Undecodable NoPicture)) | l <- [English, French]]
      `shouldBe` [Just "one picture (png, jpg, gif, bmp or tga) of that name", Just "une seule image (png, jpg, gif, bmp ou tga) de ce nom"]
  it "names severities" $ [severityName l s | l <- [English, French], s <- [Note, Warning, Error]] `shouldBe` ["note", "warning", "error", "remarque", "avertissement", "erreur"]

-- | One problem of each kind, and of each kind of each part.
problems :: [Problem]
problems =
  [UnknownWord "a" ["b"] g p | g <- [Nothing, Just "b"], p <- [TheLine, TheObject 3, TheOpening]]
    <> [MisplacedWord "a" o ["b"] TheLine | o <- [Nothing, Just "camera"]]
    <> [StrayEnd "end", MisspeltEnd "edn", MissingEnd "camera" Nothing, MissingEnd "camera" (Just ("model", 3)), UnclosedComment, BehindOpening "camera" "angle"]
    <> [RefusedValue "a" r e k | r <- refusals, e <- take 1 expectations, k <- [TheDefault, Kept "1.0"]]
    <> [RefusedValue "a" NothingThere e (Kept "1") | e <- expectations]
    <> [RepeatedProperty "point" n | n <- [1, 3]]
    <> [SecondShape "primitive", DecimalComma "angle" "20"]
    <> [ImpossibleObject "camera" f d | f <- flaws, d <- [LeftOut, Superseded]]
    <> [NoMaterialName, MissingMaterial "a" Nothing, MissingMaterial "a" (Just "b"), RepeatedMaterial "a" 3, ReplacedObject "camera" 3, SamplingWithoutRandom 4]
    <> [NoModelFile, UnknownModelFormat "a.stl", EmptyModel "a.obj", ModelCycle ["a.msr", "b.msr", "a.msr"], ModelTooDeep "a.msr" 64, TooManyParts "a.msr" (2 ^ (48 :: Int)), DifferingUvFormat "a.obj" "default"]
    <> [BrokenCurve f | f <- [RowsMissing 1, RowsMissing 2, RowsDiffer 2 3, RowRefused (NotANumber "x"), RowRefused (TooLarge "1e101")]]
    <> [PiecesWithoutLength n | n <- [1, 2]]
    <> [BadCoordinates what (NotANumber "x") | what <- [OfVertex, OfAttribute TextureCoordinate, OfAttribute Normal]]
    <> [BadFace f | f <- [NotACorner "1/x", OtherForm "1" "1/2", TooFewCorners 1, TooFewCorners 2]]
    <> [MissingVertex "9" n | n <- [0, 1, 8]]
    <> [MissingAttribute a "9" n | a <- [TextureCoordinate, Normal], n <- [1, 8]]
    <> [NoAttributes a n | a <- [TextureCoordinate, Normal], n <- [1, 2]]
    <> [CollinearTriangles 1, CollinearTriangles 2, LongLine 100, TooManyLibraries 100, UnknownMaterialOfModel "gold", MoreFaults 1, MoreFaults 2]
    <> [UnusableFile "a" u t | u <- [ForTexture, ForMask, ForModel, ForMaterialLibrary], t <- [NoSuchFile ["scenes"] Nothing, NoSuchFile ["scenes"] (Just "b"), SeveralFiles ["a/a", "b/a"], Unreadable "torn"]]
    <> [UnusableFile "a" ForTexture (Undecodable f) | f <- [NoPicture, ClaimsPixels 70000000, FewerPixels, NoHeader, CutOff, NoImage, LongCodes, TooMuchMemory, Damaged]]

refusals :: [Refusal]
refusals =
  [NothingThere, NotANumber "x", NotAnInteger "x", TooLarge "1e400", OutOfRange "-1", NoSuchChoice "x" Nothing, NoSuchChoice "x" (Just "y"), UnsafeName, NameTaken, WrongEnding, ZeroVector, ZeroComponent, SamePoint]
    <> [r g | r <- [WrongCount 3 4, NameAmongNumbers "red"], g <- [NoGuess, CommentBehind, EndBehind "end", CommaInNumber, SignsAround]]

flaws :: [Flaw]
flaws =
  [WithoutShape, ZeroSize, ZeroNormal 1e-10, NowhereToLook, UpAlongFront, FarBeforeNear, CollinearPoints, EqualPoints, InnerBeyondOuter, CurvatureBelowRadius, LensTooThin, ZeroOrientation 1e-10, NoAttenuation, InvisibleWavelength 380 780, TooManyPixels 5, TooManyOscillators 5]

expectations :: [Expectation]
expectations =
  [ARealNumber r | r <- ranges] <> [AnInteger r | r <- ranges]
    <> [AVector, AVectorWithoutZero, ADirection, TwoCoordinates, AColour ["red"], ABoolean, AChoice ["a", "b"], SomeText, AnOutputName, AnOutputNameEnding ".txt", AmountsOfLight]
  where
    ranges = [AnyNumber, AtLeast "0", Between "0" "1"]
