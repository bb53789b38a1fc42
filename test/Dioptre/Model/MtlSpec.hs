{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Model.MtlSpec
  ( spec,
  )
where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Light.Colour (black, rgb)
import Dioptre.Light.Finish
import Dioptre.Model.Mtl
import Dioptre.Model.Obj (Named (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (fromText)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "a library" $ do
    it "says what materials are" $ do
      let (mtl, faults) = library ["newmtl gold", "Ka 0.5 0.25 0", "Kd 1 2 3", "Ks 0.75", "Ns 1000", "d 0.5", "Tr 0.5", "illum 7", "Ni 1.5"]
      faults `shouldBe` []
      Map.toList (mtlMaterials mtl)
        `shouldBe` [("gold", Finish (Colours (rgb 0.5 0.25 0) (rgb 1 2 3) (rgb 0.75 0.75 0.75) 1000) NoPictures 0 0 black 1)]
    it "has singles" $ fmap shininess (material "a" ["newmtl a", "Ns 0.1"]) `shouldBe` Just (13421773 / 2 ** 27)
    it "need not say everything" $ material "a" ["newmtl a"] `shouldBe` Just unsaid
    it "has names with blanks, and pictures too" $ do
      let m = material "old gold" ["newmtl  old gold ", "map_Ka a b.png", "map_Kd ../x/y z.tga\t", "map_Ks C:\\pictures\\s.png"]
      map (\layer -> m >>= pictureOf . layer) [finishAmbient, finishDiffuse, finishSpecular] `shouldBe` [Just "a b.png", Just "../x/y z.tga", Just "C:\\pictures\\s.png"]
      fmap finishDiffuse m `shouldBe` Just (Layer (rgb 0.3 0.7 0.3) (Just (Named (Span 3 8 20) "../x/y z.tga")))
    it "has pictures with options" $
      map
        (\options -> material "a" ["newmtl a", "map_Kd " <> options <> " my leaf.png"] >>= pictureOf . finishDiffuse)
        ["-s 1 1 1", "-s 2", "-o 0.5 0.5 -s 1 2 3", "-bm 0.2 -clamp on", "-blendu off -blendv on", "-mm 0 1", "-imfchan l", "-type sphere -texres 512 -boost 2 -cc on -t 1 1"]
        `shouldBe` replicate 8 (Just "my leaf.png")
    it "has pictures whose names begin with a hyphen" $
      (material "a" ["newmtl a", "map_Kd -leaf.png"] >>= pictureOf . finishDiffuse) `shouldBe` Just "-leaf.png"
    it "goes on after a backslash, except in comments" $ do
      let (mtl, faults) = library ["# C:\\", "newmtl a", "Kd 1 \\", "  2\\", "3", "Ks 1 \\", " x 1"]
      fmap finishDiffuse (Map.lookup "a" (mtlMaterials mtl)) `shouldBe` Just (plain (rgb 1 2 3))
      faults `shouldBe` [Diagnostic (Span 7 2 3) (RefusedValue "Ks" (NotANumber "x") AmountsOfLight (Kept "0.2 0.2 0.2"))]
    it "may have comments behind numbers" $ snd (library ["newmtl a", "Kd 1 0 0 # red", "Ka 1 # grey", "Ns 3 # dull"]) `shouldBe` []
    it "has words in one case only" $ material "a" ["newmtl a", "kd 1 1 1", "NS 9"] `shouldBe` Just unsaid
    prop "is read whatever it is" $ \(UnicodeString noise) -> length (snd (readMtl (fromText "a.mtl" (Text.pack noise)))) <= keptInFull + 1

  describe "a fault" $ do
    it "is told, and the value before it stays" $ do
      let (mtl, faults) = library ["newmtl a", "Kd 1 1 1", "Kd 1 -1 1", "Kd 1 1", "Kd", "Ns -1", "Ns x", "Ns", "Ka 1 1 1e39", "map_Kd", "map_Kd -s 1", "newmtl", "Kd 0 0 0"]
      Map.toList (mtlMaterials mtl) `shouldBe` [("a", withDiffuse (plain (rgb 1 1 1)) unsaid)]
      faults
        `shouldBe` [ Diagnostic (Span 3 6 8) (RefusedValue "Kd" (OutOfRange "-1") AmountsOfLight (Kept "1.0 1.0 1.0")),
                     Diagnostic (Span 4 1 3) (RefusedValue "Kd" (WrongCount 3 2 NoGuess) AmountsOfLight (Kept "1.0 1.0 1.0")),
                     Diagnostic (Span 5 1 3) (RefusedValue "Kd" NothingThere AmountsOfLight (Kept "1.0 1.0 1.0")),
                     Diagnostic (Span 6 4 6) (RefusedValue "Ns" (OutOfRange "-1") (ARealNumber (AtLeast "0")) (Kept "5.0")),
                     Diagnostic (Span 7 4 5) (RefusedValue "Ns" (NotANumber "x") (ARealNumber (AtLeast "0")) (Kept "5.0")),
                     Diagnostic (Span 8 1 3) (RefusedValue "Ns" NothingThere (ARealNumber (AtLeast "0")) (Kept "5.0")),
                     Diagnostic (Span 9 8 12) (RefusedValue "Ka" (TooLarge "1e39") AmountsOfLight (Kept "0.2 0.2 0.2")),
                     Diagnostic (Span 10 1 7) (RefusedValue "map_Kd" NothingThere SomeText (Kept "none")),
                     Diagnostic (Span 11 1 7) (RefusedValue "map_Kd" NothingThere SomeText (Kept "none")),
                     Diagnostic (Span 12 1 7) (RefusedValue "newmtl" NothingThere SomeText (Kept "none"))
                   ]
    it "of a name that is taken leaves the first" $ do
      let (mtl, faults) = library ["", "newmtl a b", "Ns 1", "newmtl a b", "Ns 2"]
      fmap shininess (Map.lookup "a b" (mtlMaterials mtl)) `shouldBe` Just 1
      faults `shouldBe` [Diagnostic (Span 4 8 9) (RepeatedMaterial "a b" 2)]
    it "is told twenty times" $ do
      let (_, faults) = library ("newmtl a" : replicate 50 "Ns x")
      map (spanLine . diagnosticSpan) faults `shouldBe` [2 .. 22]
      map diagnosticProblem (drop 20 faults) `shouldBe` [MoreFaults 30]

  describe "the materials of a model" $ do
    it "are those of the first library that has them" $ do
      let (finishes, missing) = finishesOf [fst (library ["newmtl a", "Ns 1"]), fst (library ["newmtl a", "Ns 2", "newmtl b", "Ns 3"])] ["b", "a", "c"]
      map shininess finishes `shouldBe` [3, 1, 5]
      missing `shouldBe` ["c"]
      drop 2 finishes `shouldBe` [unknown]
    it "have a default" $ do
      finishesOf [] ["default"] `shouldBe` ([unsaid :: Finish Text], [])
      finishesOf [fst (library ["Ns 7", "newmtl a"])] ["default"] `shouldBe` ([shiny 7], [])
      finishesOf [fst (library ["Ns 7", "newmtl default", "Ns 8"])] ["default"] `shouldBe` ([shiny 8], [])
  where
    library = readMtl . fromText "a.mtl" . Text.unlines
    material :: Text -> [Text] -> Maybe (Finish Named)
    material name = Map.lookup name . mtlMaterials . fst . library
    plain c = Layer c Nothing
    shininess = shininessOf . finishColours
    shiny k = unsaid {finishColours = (finishColours unsaid) {shininessOf = k}}
    pictureOf (Layer _ picture) = namedText <$> picture
