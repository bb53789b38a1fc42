-- | What a ray meets first in a scene, by the index, by the plain list and by the obvious implementation.
module Dioptre.Render.DifferentialSpec (spec) where

import Laws.Exactness
import Test.Hspec
import Test.Hspec.QuickCheck (modifyArgs, prop)
import Test.QuickCheck (Args (..), checkCoverage, cover, elements, forAll, forAllBlind, property)
import Test.QuickCheck.Random (mkQCGen)

spec :: Spec
spec = do
  describe "the index, with meshes" $
    modifyArgs (\args -> args {replay = Just (mkQCGen 21, 0), maxSuccess = 60}) $ do
      prop "meets what the plain list does, to the bit (24000 rays)" $ forAllBlind (elements [Ordinary, Adverse] >>= \m -> crowd m 30 400) closestIsTheListsOwn
      it "is tried in all corners" $
        checkCoverage $ forAllBlind (elements [Ordinary, Adverse] >>= \m -> crowd m 30 20) $ \c -> foldr (\(name, holds) -> cover 5 holds name) (property True) (crowdCorners c)
  describe "the closest shape" $
    modifyArgs (\args -> args {replay = Just (mkQCGen 22, 0), maxSuccess = 25}) $ do
      prop "is the obvious one, in scenes as they are" $ forAll (crowd Ordinary 6 2) closestIsObvious
      prop "is the obvious one, in adverse scenes" $ forAll (crowd Adverse 6 2) closestIsObvious
